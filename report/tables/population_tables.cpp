#include "report/tables/population_tables.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/csv_text.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"
#include "core/parallel.hpp"

namespace clast {
namespace {

void class_row(CsvText& csv, const ReportedPopulation& reported, const MeasuredBlock& block,
               const std::vector<std::string>& schemes, const SchemeOptions& limits) {
  csv.cell(reported.population.name);
  csv.cell(block.name);
  if (block.unscaled) {
    csv.empty_cells(5);
  } else {
    csv.cell(block.axes.L);
    csv.cell(block.axes.I);
    csv.cell(block.axes.S);
    block.mass ? csv.cell(*block.mass) : csv.empty_cells(1);
    csv.cell(block.axis_error);
  }
  for (const std::string& scheme : schemes) {
    csv.cell(shape_class(scheme, block.as_written, limits));
  }
  for (const FormIndex& index : form_index_list()) {
    const std::optional<double> value = index.value(block.as_written);
    value ? csv.cell(*value) : csv.empty_cells(1);
  }
  csv.end_row();
}

void size_rows(CsvText& csv, const std::string& population, const SizeDistribution& size,
               const char* weighting, const SizeCurve& curve) {
  if (curve.blocks == 0) return;  // every block is unscaled
  const auto begin_row = [&] {
    csv.cell(population);
    csv.cell(name_of(size.measure));
    csv.cell(weighting);
    csv.count(curve.blocks);
  };
  const auto quantity = [&](const std::string& name, const char* unit, double value,
                            std::optional<double> error) {
    begin_row();
    csv.cell(name);
    csv.cell(unit);
    csv.cell(value);
    error ? csv.cell(*error) : csv.empty_cells(1);
    csv.end_row();
  };
  quantity("d10", "m", curve.d10, {});
  quantity("d50", "m", curve.d50, {});
  quantity("d90", "m", curve.d90, {});
  for (const SizeLaw& law : curve.laws) {
    const bool normal = law.kind == SizeLawKind::kLogNormal;
    const std::string name = normal ? "log_normal_" : "rosin_rammler_";
    quantity(name + (normal ? "median" : "d63"), "m", law.location, law.location_error);
    quantity(name + (normal ? "sigma" : "exponent"), "", law.spread, law.spread_error);
    quantity(name + "ks_distance", "", law.distance, {});
    if (law.p_value) quantity(name + "ks_p_value", "", *law.p_value, {});
  }
}

}  // namespace

std::string class_column(const std::string& scheme) {
  if (scheme == "garcia") return "shape";
  std::string column = scheme;
  std::replace(column.begin(), column.end(), '-', '_');
  return column;
}

void write_classes_csv(const PopulationReport& report, const std::filesystem::path& path,
                       unsigned threads) {
  constexpr std::size_t kChunk = 2048;   // rows of one task
  constexpr std::size_t kTogether = 32;  // tasks in memory at a time, some 20 MB
  const std::vector<std::string> schemes = report.options.chosen_schemes();
  OutputFile file(path);
  std::ofstream stream(file.temporary(), std::ios::binary);
  std::string header = "population,block,L_m,I_m,S_m,mass_kg,axis_error_m";
  for (const std::string& scheme : schemes) header += "," + class_column(scheme);
  for (const FormIndex& index : form_index_list()) header += std::string(",") + index.name;
  stream << header << "\n";
  for (const ReportedPopulation& reported : report.populations) {
    const std::vector<MeasuredBlock>& blocks = reported.population.blocks;
    for (std::size_t first = 0; first < blocks.size(); first += kChunk * kTogether) {
      const std::size_t last = std::min(first + kChunk * kTogether, blocks.size());
      std::vector<std::string> chunks((last - first + kChunk - 1) / kChunk);
      parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
        CsvText csv;
        const std::size_t begin = first + chunk * kChunk;
        for (std::size_t i = begin; i < std::min(begin + kChunk, last); ++i) {
          class_row(csv, reported, blocks[i], schemes, report.options.limits);
        }
        chunks[chunk] = csv.take();
      });
      for (const std::string& chunk : chunks) stream << chunk;
    }
  }
  stream.close();
  if (!stream) throw InputError(path.string() + ": writing failed; is the disk full?");
  file.commit();
}

std::string shares_csv(const PopulationReport& report) {
  CsvText csv;
  csv.header(
      "population,scheme,class,blocks,share,share_low,share_high,"
      "mass_kg,mass_share,mass_share_low,mass_share_high");
  for (const ReportedPopulation& reported : report.populations) {
    for (const SchemeShares& scheme : reported.summary.schemes) {
      for (const ClassShare& share : scheme.shares) {
        csv.cell(reported.population.name);
        csv.cell(scheme.scheme);
        csv.cell(share.name);
        csv.count(share.count);
        for (const double value : {share.share, share.low, share.high}) csv.cell(value);
        if (reported.summary.weighed == 0) {
          csv.empty_cells(4);
        } else {
          for (const double value : {share.mass, share.mass_share, share.mass_low, share.mass_high})
            csv.cell(value);
        }
        csv.end_row();
      }
    }
  }
  return csv.take();
}

std::string sizes_csv(const PopulationReport& report) {
  CsvText csv;
  csv.header("population,size,weighting,blocks,quantity,unit,value,standard_error");
  for (const ReportedPopulation& reported : report.populations) {
    const SizeDistribution& size = reported.summary.size;
    size_rows(csv, reported.population.name, size, "number", size.by_number);
    if (size.by_mass) size_rows(csv, reported.population.name, size, "mass", *size.by_mass);
  }
  return csv.take();
}

std::string tests_csv(const PopulationReport& report) {
  CsvText csv;
  csv.header("test,populations,quantity,statistic,degrees_of_freedom,p_value,p_from,words");
  for (const ReportedPopulation& reported : report.populations) {
    for (const SizeShape& one : reported.summary.size_and_shape) {
      csv.cell("spearman");
      csv.cell(reported.population.name);
      csv.cell(name_of(report.options.size) + " and " + one.measure->name);
      csv.cell(one.test ? one.test->statistic : NAN);
      csv.empty_cells(1);
      csv.cell(one.test ? one.test->p_value : NAN);
      csv.cell(!one.test ? "" : one.test->exact ? "all orders" : "Student's t");
      csv.cell(size_shape_words(one, report.options.size));
      csv.end_row();
    }
  }
  if (!report.comparison) return csv.take();
  const std::string pair = report.comparison->name_a + " and " + report.comparison->name_b;
  for (const MeasureDifference& one : report.comparison->measures) {
    csv.cell("kolmogorov-smirnov");
    csv.cell(pair);
    csv.cell(one.measure->name);
    csv.cell(one.test ? one.test->statistic : NAN);
    csv.empty_cells(1);
    csv.cell(one.test ? one.test->p_value : NAN);
    csv.cell(!one.test ? "" : one.test->exact ? "all deals" : "limit for many blocks");
    csv.cell(one.words);
    csv.end_row();
  }
  for (const ClassDifference& one : report.comparison->schemes) {
    csv.cell("chi-squared");
    csv.cell(pair);
    csv.cell(one.scheme);
    csv.cell(one.test ? one.test->chi_squared : NAN);
    one.test ? csv.count(one.test->freedom) : csv.empty_cells(1);
    csv.cell(one.test ? one.test->p_value : NAN);
    csv.cell(!one.test             ? std::string()
             : one.test->draws > 0 ? std::to_string(one.test->draws) + " random tables"
                                   : std::string("chi-squared distribution"));
    csv.cell(one.words);
    csv.end_row();
  }
  return csv.take();
}

}  // namespace clast
