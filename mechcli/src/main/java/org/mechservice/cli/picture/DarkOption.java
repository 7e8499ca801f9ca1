package org.mechservice.cli.picture;

import picocli.CommandLine.Option;

/** Whether a diagram is dark. */
final class DarkOption {
  @Option(
      names = "--dark",
      description =
          "Light lines on black. If left out, PNG files are light, SVG and HTML files as their"
              + " reader prefers.")
  private boolean dark;

  boolean isDark() {
    return dark;
  }
}
