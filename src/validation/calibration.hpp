// Finds the parameters of giving way (model/giving_way.hpp) by the recordings, with
// cross-validation by site and by manoeuvre.
//
// Search, the same on every machine: a low-discrepancy sequence over the whole box, then rounds of
// it in boxes half as wide each time about the best so far. Every fold searches for itself: it
// shares the first points, which no score has chosen, and sees none of what another fold found. The
// best of all clips are scored again with seeds that the search did not use.
//
// Choice: the misfit is flat along a valley, in which the best single point is an accident of the
// clips. So of the points within one standard error of the best (of the difference of the two, by
// bootstrap over clips; Breiman et al. 1984, the one standard error rule) that one is taken on
// which the folds agree most: whose worst fold, a site or a manoeuvre left out, is nearest to the
// best of that fold. The whole valley is reported.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "validation/validation.hpp"

namespace pedzone {

/// A parameter that is searched for.
struct Searched {
  std::string_view key;  ///< as in parameter_list()
  double least, most;
  bool logarithmic = false;
};
std::span<const Searched> searched_parameters();

struct CalibrationOptions {
  int seeds = 5;
  int first = 128;              ///< points over the whole box
  int rounds = 4, points = 16;  ///< of the search about the best
  int finalists = 16;           ///< good points of all clips that are scored again
  int resamples = 100;          ///< of the bootstrap over clips
  std::string log;              ///< file of all evaluations so far; read first, then appended to
};

/// Which clips a fold is tuned on; it is scored on the others ("all": on all).
struct Fold {
  std::string name;         ///< "all", "without citr", "without dut: intersection", ...
  std::vector<bool> tuned;  ///< by clip
};

struct FoldResult {
  Fold fold;
  Parameters parameters;
  double misfit = 0.0;              ///< on the clips it is tuned on
  std::vector<ValidationRow> rows;  ///< of the clips that it was not tuned on (of all: all),
                                    ///< recorded and "calibrated" in turns
};

/// A good point, scored with other seeds than the search used.
struct Finalist {
  Parameters parameters;
  double misfit = 0.0;
  double error = 0.0;   ///< standard error of what it has more than the best
  double regret = 0.0;  ///< how much more misfit than the best, in the fold where that is most
  bool in_valley = false, chosen = false;
};

struct CalibrationResult {
  std::vector<FoldResult> folds;    ///< "all" first
  std::vector<Finalist> finalists;  ///< the best first
  int evaluations = 0, reused = 0;
};

/// How far a model is from the recording: mean over sites and manoeuvres of squared deviations,
/// each over what is tolerated (clearance 15 %, its K–S 0.20, ...). 1: on the border
/// everywhere.
double misfit(const std::vector<Clip>& clips, const ScoredRuns& runs,
              const std::vector<bool>& used);

/// The same with each clip counted so often, as a bootstrap draws them.
double misfit(const std::vector<Clip>& clips, const ScoredRuns& runs,
              const std::vector<int>& times);

/// Throws InputError where the log cannot be read, and when there are not at least two clips with
/// moving vehicles (nothing to cross-validate with).
CalibrationResult calibrate(const std::vector<Clip>& clips, const CalibrationOptions& options,
                            const Progressed& progressed);

}  // namespace pedzone
