#include "app/study.hpp"

#include <memory>

#include "app/command_line/common_options.hpp"
#include "app/command_line/values.hpp"

namespace pedzone {
namespace {

constexpr int kMostJobs = 1024;

constexpr const char* kFooter =
    "Example: what changes if people walk like this, instead of like SUMO's own? Three lines ask "
    "it:\n\n"
    "  <study seeds=\"1-20\">\n"
    "    <scenario file=\"town.sumocfg\"/>\n"
    "  </study>\n\n"
    "  pedzone study run study.xml --out results/\n\n"
    "runs the scenario with 20 seeds by SUMO's striping and by pedzone's heuristic, with the same\n"
    "people and vehicles, and writes results/report.html: what differs, by how much, how sure.\n"
    "More: pedzone study run --help";

constexpr const char* kRunFooter =
    "Examples:\n"
    "  pedzone study run study.xml --out results/ --jobs 2\n"
    "  pedzone study run study.xml --out results/      # the same again goes on where it stopped\n"
    "  pedzone study run study.xml --out results/ --slurm --time 2:00:00    # on a cluster\n"
    "  pedzone study status results/                   # how far it is, and what failed\n\n"
    "A study file names scenarios, models, seeds, and what varies:\n"
    "  <study seeds=\"1-50\" models=\"striping heuristic ./mine.so\" end=\"900\" "
    "timeLimit=\"600\">\n"
    "    <scenario file=\"town.sumocfg\" zone=\"town.zone.xml\" options=\"--step-length 0.2\"/>\n"
    "    <factor id=\"sight\" parameter=\"sight\" values=\"5 10\"/>   <!-- parameter of zones -->\n"
    "    <factor id=\"weather\" zone=\"weather\" values=\"fair rain\"/>  <!-- attribute of zones "
    "-->\n"
    "    <factor id=\"people\" panel=\"number\" values=\"50 200\"/>  <!-- made beside those there "
    "are -->\n"
    "    <factor id=\"traffic\" sumo=\"scale\" values=\"1 2\"/>          <!-- option of SUMO -->\n"
    "  </study>\n"
    "All combinations are run, with each seed. Paths are relative to the study file.\n\n"
    "A run that fails, hangs (timeLimit, in s) or is killed is tried once more; then the study\n"
    "goes on without it. Ctrl-C keeps what is done. A run is made again when it is missing, was\n"
    "killed, or an input of it has changed. Each run has its folder, results/runs/ID, with its\n"
    "outputs, log.txt and record.json.\n"
    "Exit codes: 0 done, 2 input at fault, 4 some runs failed, 130 interrupted.";

void add_run(CLI::App& study, int& code) {
  auto options = std::make_shared<StudyRunOptions>();
  CLI::App* command =
      study.add_subcommand("run", "Make the runs of a study that are missing, and its report");
  command->footer(kRunFooter);
  command->add_option("study", options->file, "Study file (.xml)")->required();
  command->add_option("--out", options->results, "Folder for the results")
      ->required()
      ->type_name(kFolder);
  command->add_option("--jobs", options->jobs, "Runs at the same time; 0: one for each core")
      ->check(whole_number_in(0, kMostJobs))
      ->type_name(kNumber)
      ->capture_default_str();
  command->add_flag("--retry-failed", options->retry_failed, "Try failed runs again, too");
  add_slurm_options(*command, options->slurm);
  command->get_option("--slurm")->excludes(command->get_option("--jobs"));
  command->callback([options, &code] { code = study_run(*options); });
}

void add_status(CLI::App& study, int& code) {
  auto options = std::make_shared<StudyStatusOptions>();
  CLI::App* command = study.add_subcommand("status", "Tell how far a study is and what failed");
  command->footer(
      "Example:\n  pedzone study status results/\n\n"
      "Also while it runs. Exit codes: 0 nothing failed, 2 input at fault, 4 some runs failed.");
  command->add_option("results", options->results, "Folder of the results")->required();
  add_json_flag(*command, options->json);
  command->callback([options, &code] { code = study_status(*options); });
}

void add_report(CLI::App& study, int& code) {
  auto results = std::make_shared<std::string>();
  CLI::App* command =
      study.add_subcommand("report", "Write the report and the tables of what is done so far");
  command->footer(
      "Example:\n  pedzone study report results/\n\n"
      "Writes report.html, summary.csv, summary.json and runs.csv there.\n"
      "Exit codes: 0 done, 2 input at fault, 4 some runs failed.");
  command->add_option("results", *results, "Folder of the results")->required();
  command->callback([results, &code] { code = study_report(*results); });
}

}  // namespace

void add_study(CLI::App& app, int& code) {
  CLI::App* study = app.add_subcommand(
      "study", "Compare walking models over many runs: plan, run, resume, measure, report");
  study->footer(kFooter);
  study->require_subcommand(0, 1);
  add_run(*study, code);
  add_status(*study, code);
  add_report(*study, code);
  add_slurm_jobs(*study, code);
}

}  // namespace pedzone
