#pragma once
/// The script of the 3-D view: reads #scene-data and draws into #scene with three.js.
namespace clast::report_detail {

extern const char* const kSceneScript;

}  // namespace clast::report_detail
