# The report's page as texts in the library: report_page_sources are the C++ files that hold them.
pedzone_page_sources(report_page_sources ${CMAKE_CURRENT_SOURCE_DIR}/report
  page.mustache.html kReportPage styles.html kReportStyles scripts.html kReportScripts)
