#include "app/commands/shared_runs.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <sstream>
#include <streambuf>

#include "app/option_values.hpp"
#include "core/error.hpp"

namespace clast {
namespace {

void silence() {
  // Streams that swallow everything stay good, unlike closed ones, which main calls a failure.
  struct Swallow : std::streambuf {
    int overflow(int character) override { return traits_type::not_eof(character); }
  };
  // Never destroyed: the streams are flushed after everything else.
  static Swallow& swallow = *new Swallow;
  std::cout.rdbuf(&swallow);
  std::cerr.rdbuf(&swallow);
}

}  // namespace

std::optional<Shard> parse_shard(const std::string& text) {
  if (text.empty()) return std::nullopt;
  Shard shard;
  std::istringstream words(text);
  char slash = 0;
  const bool whole = text.find_first_not_of("0123456789/") == std::string::npos &&
                     static_cast<bool>(words >> shard.index >> slash >> shard.count) &&
                     slash == '/' && words.peek() == std::istringstream::traits_type::eof();
  if (!whole) {
    throw CLI::ValidationError("--shard: \"" + text + "\" is not of the form i/n, for example 2/4");
  }
  check_usage([&] { shard.check(); });
  return shard;
}

void run_in_team(const std::function<void(ProcessTeam& team)>& command) {
  ProcessTeam team;
  if (team.is_leader()) return command(team);
  silence();
  try {
    command(team);
  } catch (const Error&) {
    // The leader knows, says why and fails. mpirun ends all as soon as one fails: it must be the
    // first to do so, or its message is lost.
  }
}

}  // namespace clast
