package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.shell.ExitStatus;

/**
 * The launcher script, in a house of cards: a folder with the script, and a search path with the
 * tools it uses, a {@code java} and an {@code mvn} that only say what they were asked.
 *
 * <pre>
 * mechservice/          mech, pom.xml, mechml.dtd, mechcli/src/main
 * bin/                  java, mvn, and links to sh, sed, ...
 * </pre>
 */
class LauncherTest {
  private static final List<String> TOOLS =
      List.of(
          "sh",
          "sed",
          "head",
          "find",
          "cat",
          "cp",
          "mkdir",
          "rm",
          "dirname",
          "readlink",
          "ls",
          "touch",
          "grep",
          "sleep",
          "kill",
          "sort");

  private static final String JDK =
      """
      #!/bin/sh
      case $* in
        *XshowSettings*) echo '    java.home = /some/jdk' >&2 ;;
        -version) echo 'openjdk version "17.0.15" 2025-04-15' >&2 ;;
        --list-modules) echo 'java.base@17'; echo 'jdk.compiler@17' ;;
        *DumpLoadedClassList=*--mode*) list=${*#*List=}; echo "${*##*--mode}" >"${list%% *}" ;;
        *Xshare:dump*)
          list=${*#*SharedClassListFile=} archive=${*#*SharedArchiveFile=}
          cp "${list%% *}" "${archive%% *}" ;;
        *) echo "started: $*" ;;
      esac
      """;

  private static final String MAVEN =
      """
      #!/bin/sh
      echo "built with $JAVA_HOME" >>built
      mkdir -p mechcli/target/lib
      echo jar >mechcli/target/mechcli.jar
      """;

  private final Path house;
  private final Path bin;

  LauncherTest(@TempDir Path folder) {
    house = folder.resolve("mechservice");
    bin = folder.resolve("bin");
  }

  @BeforeEach
  void furnish() throws IOException {
    Files.createDirectories(house.resolve("mechcli/src/main"));
    Files.createDirectories(bin);
    Files.copy(Path.of("../mech"), house.resolve("mech"));
    Files.writeString(house.resolve("pom.xml"), "");
    for (String tool : TOOLS) {
      for (String folder : List.of("/usr/bin", "/bin")) {
        if (Files.exists(Path.of(folder, tool)) && !Files.exists(bin.resolve(tool))) {
          Files.createSymbolicLink(bin.resolve(tool), Path.of(folder, tool));
        }
      }
    }
    program("java", JDK);
    program("mvn", MAVEN);
  }

  private void program(String name, String script) throws IOException {
    Path file = bin.resolve(name);
    Files.writeString(file, script);
    assertThat(file.toFile().setExecutable(true)).isTrue();
  }

  @Test
  void firstUseBuildsAndStarts() throws Exception {
    Ended first = start(house.resolve("mech"), "check", "a b.xml");
    assertThat(first.err).contains("mech: building");
    assertThat(first.out).contains("mechcli/target/mechcli.jar check a b.xml");
    assertThat(house.resolve("built")).hasContent("built with /some/jdk");
  }

  @Test
  void buildNamesTheModuleThatIsBuilt() throws Exception {
    program(
        "mvn",
        MAVEN
            + "echo '[INFO] Building mech command line 0.1.0            [13/13]'\n"
            + "echo '[INFO] Building jar: /somewhere/mechcli.jar'\n");
    Ended first = start(house.resolve("mech"));
    assertThat(first.err.lines().skip(1))
        .containsExactly("mech: building [13/13] mech command line 0.1.0");
    assertThat(house.resolve("mechcli/target/build.log")).content().hasLineCount(2);
  }

  @Test
  void secondUseOnlyStarts() throws Exception {
    start(house.resolve("mech"));
    Ended second = start(house.resolve("mech"));
    assertThat(second.err).isEmpty();
    assertThat(house.resolve("built")).content().hasLineCount(1);
  }

  @Test
  void newerSourceIsBuiltAgain() throws Exception {
    start(house.resolve("mech"));
    Path source = house.resolve("mechcli/src/main/New.java");
    Files.writeString(source, "");
    Files.setLastModifiedTime(source, FileTime.from(Instant.now().plusSeconds(60)));
    start(house.resolve("mech"));
    assertThat(house.resolve("built")).content().hasLineCount(2);
  }

  @Test
  void startsWithTheArchiveOfTheBuild() throws Exception {
    String archive = "-XX:SharedArchiveFile=" + house.toRealPath() + "/mechcli/target/mech.jsa";
    assertThat(start(house.resolve("mech"), "check", "m.xml").out).contains(archive);
  }

  @Test
  void archiveHasTheClassesOfRemoteAndOfLocalRuns() throws Exception {
    start(house.resolve("mech"), "check", "m.xml");
    assertThat(house.resolve("mechcli/target/mech.jsa")).content().contains("remote", "local");
  }

  @Test
  void startsWithoutAnArchiveWhereNoneCanBeMade() throws Exception {
    program("java", JDK.replace("cp \"${list%% *}\" \"${archive%% *}\"", "exit 1"));
    Ended mech = start(house.resolve("mech"), "check", "m.xml");
    assertThat(mech.out).startsWith("started").doesNotContain("SharedArchiveFile");
    assertThat(mech.err).hasLineCount(1);
  }

  @Test
  void serversRunWithTheMachinesOwnSettings() throws Exception {
    assertThat(start(house.resolve("mech"), "check", "m.xml").out).contains("UseSerialGC");
    assertThat(start(house.resolve("mech"), "server").out).doesNotContain("UseSerialGC");
    assertThat(start(house.resolve("mech"), "simhost").out).doesNotContain("UseSerialGC");
  }

  @Test
  void findsItsHouseThroughSymbolicLinks() throws Exception {
    Path near = house.resolve("near");
    Files.createSymbolicLink(near, Path.of("mech"));
    Path far = bin.resolve("far");
    Files.createSymbolicLink(far, near);
    assertThat(start(far, "x").out).contains(house.toRealPath() + "/mechcli/target/mechcli.jar x");
  }

  @Test
  void saysWhatIsMissingWithoutJava() throws Exception {
    Files.delete(bin.resolve("java"));
    assertRefuses("S-049 mech needs Java 17 or newer, and there is no java.");
  }

  @Test
  void refusesAnOldJavaByItsVersion() throws Exception {
    program("java", "#!/bin/sh\necho 'openjdk version \"11.0.2\"' >&2\n");
    assertRefuses("S-049 mech needs Java 17 or newer; " + bin.resolve("java") + " is version 11.");
  }

  @Test
  void refusesToBuildWithARuntimeWithoutCompiler() throws Exception {
    program("java", JDK.replace("; echo 'jdk.compiler@17'", ""));
    assertRefuses("is a run time without compiler");
  }

  @Test
  void startsWhatIsBuiltOnARuntimeWithoutCompiler() throws Exception {
    start(house.resolve("mech"));
    program("java", JDK.replace("; echo 'jdk.compiler@17'", ""));
    assertThat(start(house.resolve("mech"), "check", "m.xml").out).startsWith("started");
  }

  @Test
  void saysThatMavenIsNeededForTheBuild() throws Exception {
    Files.delete(bin.resolve("mvn"));
    assertRefuses("S-049 mech has to be built first, and there is no mvn.");
  }

  @Test
  void failedBuildNamesItsLogAndLeavesNoLock() throws Exception {
    program("mvn", "#!/bin/sh\necho 'no network'\nexit 1\n");
    Path log = house.toRealPath().resolve("mechcli/target/build.log");
    assertRefuses("S-049 the build failed; " + log + " says why.");
    assertThat(log).hasContent("no network");
    assertThat(house.resolve("mechcli/target/build.lock")).doesNotExist();
  }

  @Test
  void takesOverTheLockOfABuildThatDied() throws Exception {
    Path lock = house.resolve("mechcli/target/build.lock");
    Files.createDirectories(lock);
    // Process ids end far below this on every system the script runs on.
    Files.writeString(lock.resolve("pid"), "999999999");
    assertThat(start(house.resolve("mech")).out).startsWith("started");
  }

  /** Lays out the launcher as a release archive has it; returns its folder. */
  private Path release() throws IOException {
    Path release = house.resolve("release");
    Files.createDirectories(release.resolve("bin"));
    Files.createDirectories(release.resolve("lib"));
    Files.copy(house.resolve("mech"), release.resolve("bin/mech"));
    Files.writeString(release.resolve("lib/mechcli.jar"), "");
    Files.writeString(release.resolve("lib/asm.jar"), "");
    program("java", JDK.replace("; echo 'jdk.compiler@17'", ""));
    Files.delete(bin.resolve("mvn"));
    return release.toRealPath();
  }

  @Test
  void releaseStartsItsLibrariesWithoutCompilerAndMaven() throws Exception {
    Path release = release();
    Ended mech = start(release.resolve("bin/mech"), "check", "a b.xml");
    assertThat(mech.err).isEmpty();
    assertThat(mech.out)
        .contains(release + "/lib/mechcli.jar:" + release + "/lib/asm.jar")
        .endsWith("org.mechservice.cli.Mech check a b.xml\n");
  }

  @Test
  void releaseArchivesItsClassesInItsOwnFolder() throws Exception {
    Path release = release();
    assertThat(start(release.resolve("bin/mech"), "check", "m.xml").out)
        .contains("-XX:SharedArchiveFile=" + release + "/cache/mech.jsa");
    assertThat(release.resolve("cache/mech.jsa")).content().contains("remote", "local");
  }

  @Test
  void releaseInAFolderOfAnotherUserStartsWithoutAnArchive() throws Exception {
    Path release = release();
    // Where the folder would be, nobody can make one.
    Files.writeString(release.resolve("cache"), "");
    Ended mech = start(release.resolve("bin/mech"), "check", "m.xml");
    assertThat(mech.status).isZero();
    assertThat(mech.out).startsWith("started").doesNotContain("SharedArchiveFile");
  }

  private void assertRefuses(String message) throws Exception {
    Ended mech = start(house.resolve("mech"), "--version");
    assertThat(mech.status).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(mech.err).contains(message);
    assertThat(mech.out).isEmpty();
  }

  /** What a process said and how it ended. */
  private record Ended(int status, String out, String err) {}

  private Ended start(Path script, String... words) throws Exception {
    ProcessBuilder builder = new ProcessBuilder(script.toString()).directory(house.toFile());
    builder.command().addAll(List.of(words));
    builder.environment().clear();
    builder.environment().put("PATH", bin.toString());
    Process process = builder.start();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
    return new Ended(process.exitValue(), out, err);
  }
}
