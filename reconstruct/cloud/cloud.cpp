#include "reconstruct/cloud/cloud.hpp"

#include <pcl/features/normal_3d.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include <algorithm>
#include <cmath>

namespace clast::reconstruct_detail {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Vec3 middle(std::span<const Vec3> points) {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return points.empty() ? Vec3::Zero() : Vec3(0.5 * (low + high));
}

Cloud::Ptr cloud_about(std::span<const Vec3> points, const Vec3& origin) {
  Cloud::Ptr cloud(new Cloud);
  cloud->reserve(points.size());
  for (const Vec3& point : points) {
    const Eigen::Vector3f local = (point - origin).cast<float>();
    cloud->push_back(pcl::PointXYZ(local.x(), local.y(), local.z()));
  }
  return cloud;
}

Cloud::Ptr local_cloud(std::span<const Vec3> points) { return cloud_about(points, middle(points)); }

}  // namespace

std::vector<std::uint32_t> find_inliers(std::span<const Vec3> points, int neighbours,
                                        double deviations) {
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
  filter.setInputCloud(local_cloud(points));
  filter.setMeanK(neighbours);
  filter.setStddevMulThresh(deviations);
  pcl::Indices kept;
  filter.filter(kept);
  std::vector<std::uint32_t> inliers(kept.begin(), kept.end());
  std::sort(inliers.begin(), inliers.end());
  return inliers;
}

std::vector<Vec3> decimate_points(std::span<const Vec3> points, double cell) {
  const Vec3 origin = middle(points);
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  filter.setInputCloud(cloud_about(points, origin));
  const auto side = static_cast<float>(cell);
  filter.setLeafSize(side, side, side);
  Cloud sparse;
  filter.filter(sparse);
  std::vector<Vec3> result;
  result.reserve(sparse.size());
  for (const pcl::PointXYZ& p : sparse) {
    result.push_back(origin + p.getVector3fMap().cast<double>());
  }
  return result;
}

std::vector<std::vector<std::uint32_t>> find_clusters(std::span<const Vec3> points, double max_gap,
                                                      std::size_t min_points) {
  const Cloud::Ptr cloud = local_cloud(points);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  extraction.setClusterTolerance(max_gap);
  extraction.setMinClusterSize(static_cast<pcl::uindex_t>(min_points));
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(cloud);
  std::vector<pcl::PointIndices> found;
  if (!points.empty()) extraction.extract(found);
  std::vector<std::vector<std::uint32_t>> sets;
  for (const pcl::PointIndices& set : found) {
    sets.emplace_back(set.indices.begin(), set.indices.end());
    std::sort(sets.back().begin(), sets.back().end());
  }
  std::sort(sets.begin(), sets.end(), [](const auto& a, const auto& b) {
    return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
  });
  return sets;
}

std::vector<Vec3> estimate_normals(std::span<const Vec3> points, int neighbours) {
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  estimation.setInputCloud(local_cloud(points));
  estimation.setSearchMethod(tree);
  estimation.setKSearch(neighbours);
  pcl::PointCloud<pcl::Normal> found;
  estimation.compute(found);
  std::vector<Vec3> normals;
  normals.reserve(found.size());
  for (const pcl::Normal& n : found) {
    const Vec3 normal = n.getNormalVector3fMap().cast<double>();
    normals.push_back(normal.allFinite() ? normal.normalized() : Vec3::UnitZ());
  }
  return normals;
}

struct PointTree::Impl {
  Vec3 origin;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
};

PointTree::PointTree(std::span<const Vec3> points) : impl_(std::make_unique<Impl>()) {
  impl_->origin = middle(points);
  impl_->tree.setInputCloud(cloud_about(points, impl_->origin));
}

PointTree::~PointTree() = default;

std::vector<PointTree::Neighbour> PointTree::nearest_neighbours(const Vec3& position,
                                                                int count) const {
  const Eigen::Vector3f local = (position - impl_->origin).cast<float>();
  pcl::Indices found;
  std::vector<float> squares;
  impl_->tree.nearestKSearch(pcl::PointXYZ(local.x(), local.y(), local.z()), count, found, squares);
  std::vector<Neighbour> near(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    near[i] = {static_cast<std::uint32_t>(found[i]), std::sqrt(static_cast<double>(squares[i]))};
  }
  return near;
}

double mean_spacing(std::span<const Vec3> points) {
  if (points.size() < 2) return 0.0;
  constexpr std::size_t kSamples = 2000;
  const PointTree tree(points);
  const std::size_t step = std::max<std::size_t>(1, points.size() / kSamples);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); i += step, ++count) {
    sum += tree.nearest_neighbours(points[i], 2).back().distance;
  }
  return sum / static_cast<double>(count);
}

}  // namespace clast::reconstruct_detail
