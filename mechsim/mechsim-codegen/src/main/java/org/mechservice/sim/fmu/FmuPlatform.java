package org.mechservice.sim.fmu;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** A kind of machine that an FMU has a binary for. */
public enum FmuPlatform {
  LINUX64("linux64", "x86_64-linux", "linux64", ".so", "x86_64-linux-gnu.2.17"),
  WIN64("win64", "x86_64-windows", "win64", ".dll", "x86_64-windows-gnu"),
  DARWIN_AARCH64("darwin-aarch64", "aarch64-darwin", "darwin64", ".dylib", "aarch64-macos"),
  LINUX_AARCH64("linux-aarch64", "aarch64-linux", "aarch64-linux", ".so", "aarch64-linux-gnu.2.17");

  /** Word for an FMU without binaries. */
  public static final String SOURCE = "source";

  private final String label;
  private final String folder3;
  private final String folder2;
  private final String suffix;
  private final String zigTarget;

  FmuPlatform(String label, String folder3, String folder2, String suffix, String zigTarget) {
    this.label = label;
    this.folder3 = folder3;
    this.folder2 = folder2;
    this.suffix = suffix;
    this.zigTarget = zigTarget;
  }

  /** Returns the name that users write. */
  public String label() {
    return label;
  }

  /** Returns the target as zig names it. */
  String zigTarget() {
    return zigTarget;
  }

  /** Returns the path of the binary in the FMU. */
  String path(FmiVersion version, String identifier) {
    String folder = version == FmiVersion.FMI_2 ? folder2 : folder3;
    return "binaries/" + folder + "/" + identifier + suffix;
  }

  /** Returns the platform of this machine; empty if FMI has no name for it here. */
  public static Optional<FmuPlatform> ofThisMachine() {
    String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
    String processor = System.getProperty("os.arch", "").toLowerCase(Locale.ROOT);
    boolean arm = processor.equals("aarch64") || processor.equals("arm64");
    boolean intel = processor.equals("amd64") || processor.equals("x86_64");
    if (system.startsWith("linux")) {
      return arm ? Optional.of(LINUX_AARCH64) : intel ? Optional.of(LINUX64) : Optional.empty();
    }
    if (system.startsWith("mac")) {
      return arm ? Optional.of(DARWIN_AARCH64) : Optional.empty();
    }
    return system.startsWith("windows") && intel ? Optional.of(WIN64) : Optional.empty();
  }

  /**
   * Returns the platforms of a list.
   *
   * @param list names separated by commas, or {@code source} for none
   * @throws IllegalArgumentException if a name is not known; the message names those that are
   */
  public static Set<FmuPlatform> parse(String list) {
    Set<FmuPlatform> platforms = EnumSet.noneOf(FmuPlatform.class);
    if (list.strip().equals(SOURCE)) {
      return platforms;
    }
    for (String name : list.split(",", -1)) {
      platforms.add(
          Arrays.stream(values())
              .filter(platform -> platform.label.equals(name.strip()))
              .findFirst()
              .orElseThrow(() -> unknown(name.strip())));
    }
    return platforms;
  }

  private static IllegalArgumentException unknown(String name) {
    String known =
        Arrays.stream(values()).map(FmuPlatform::label).collect(Collectors.joining(", "));
    return new IllegalArgumentException(
        "no platform \"" + name + "\": write " + known + ", several with commas, or " + SOURCE);
  }
}
