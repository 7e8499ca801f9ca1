package org.mechservice.cli.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.shell.UsageException;

/** Macros of xacro, with scripts in place of the program. */
class XacroTest {
  private static final String MACROS =
      "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arg name='side'/></robot>";

  @TempDir private Path folder = Path.of("");

  private String program(String body) throws IOException {
    Path script = Files.writeString(folder.resolve("xacro"), "#!/bin/sh\n" + body + "\n");
    assertThat(script.toFile().setExecutable(true)).isTrue();
    return script.toString();
  }

  private Path file(String text) throws IOException {
    return Files.writeString(folder.resolve("arm.urdf.xacro"), text);
  }

  @Test
  void macrosAreExpandedWithTheirArguments() throws IOException {
    String program = program("echo \"<robot name='$2'/> $(basename $1)\"");
    assertThat(Xacro.expanded(program, file(MACROS), List.of("side:=left")))
        .hasValueSatisfying(
            robot ->
                assertThat(new String(robot, StandardCharsets.UTF_8).strip())
                    .isEqualTo("<robot name='side:=left'/> arm.urdf.xacro"));
  }

  @Test
  void robotWithoutMacrosIsLeftToTheImport() throws IOException {
    Path plain = file("<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'/>");
    assertThat(Xacro.expanded(program("exit 1"), plain, List.of())).isEmpty();
  }

  @Test
  void valuesThatNothingReadsAreRefused() throws IOException {
    Path plain = file("<robot name='r'/>");
    assertThatThrownBy(() -> Xacro.expanded(plain, List.of("side:=left")))
        .isInstanceOf(UsageException.class)
        .hasMessageContaining("--xacro side:=left has no meaning: it has no macros of xacro");
    assertThatThrownBy(() -> Xacro.refuse("standard input", List.of("side:=left"), "it is a pipe"))
        .isInstanceOf(UsageException.class)
        .hasMessageContaining("standard input: --xacro side:=left has no meaning: it is a pipe");
  }

  /** The import then says what to install. */
  @Test
  void withoutTheProgramTheFileIsLeftToTheImport() throws IOException {
    String nowhere = folder.resolve("nowhere").toString();
    assertThat(Xacro.expanded(nowhere, file(MACROS), List.of())).isEmpty();
  }

  @Test
  void whatTheProgramRefusesIsSaidInItsWords() throws IOException {
    String program = program("echo 'Undefined substitution argument side' >&2; exit 2");
    Path file = file(MACROS);
    assertThatThrownBy(() -> Xacro.expanded(program, file, List.of()))
        .isInstanceOf(UsageException.class)
        .hasMessageContaining("M-080")
        .hasMessageContaining("arm.urdf.xacro")
        .hasMessageContaining("Undefined substitution argument side");
  }
}
