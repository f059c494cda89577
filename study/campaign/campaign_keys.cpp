#include "study/campaign/campaign_keys.hpp"

#include "study/campaign/campaign_reading.hpp"

namespace clast {

using namespace study_detail;

const std::vector<KeyTable>& campaign_key_tables() {
  static const std::vector<KeyTable> tables = {
      blocks_keys(),  vary_keys(),           block_group_keys(), terrain_keys(),
      ground_keys(),  ensemble_keys(),       release_keys(),     multi_block_release_keys(),
      contact_keys(), between_blocks_keys(), barrier_keys(),     run_keys()};
  return tables;
}

}  // namespace clast
