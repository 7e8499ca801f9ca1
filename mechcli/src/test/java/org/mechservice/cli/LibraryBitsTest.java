package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.guard.UserCode;
import org.mechservice.library.MechModel;

/** The library in process and {@code mech simulate} write the same bytes. */
@Tag("slow")
class LibraryBitsTest {
  @TempDir private Path folder = Path.of("");

  @ParameterizedTest
  @ValueSource(
      strings = {
        "pendulum/pendulum.xml",
        "elements/contact.xml",
        "five-point-suspension/five-point-suspension.xml",
        "elements/inverseDynamic.xml",
        "elements/linearize.xml",
        "elements/force.xml"
      })
  void rowsAreTheSameToTheBit(String example) throws Exception {
    Path model = Path.of("../examples").resolve(example);
    Path byCommand = folder.resolve("command.csv");
    Path byLibrary = folder.resolve("library.csv");
    StringWriter said = new StringWriter();
    PrintWriter err = new PrintWriter(said);
    Path trusted = model.resolveSibling(".");
    int status =
        Mech.run(
            err,
            err,
            "simulate",
            model.toString(),
            "--user-code",
            trusted.toString(),
            "--unconfined",
            "--out",
            byCommand.toString(),
            "--quiet");
    assertThat(status).as(said.toString()).isZero();
    MechModel.read(model, UserCode.in(trusted).unconfined()).simulate(byLibrary);
    assertThat(byLibrary).hasSameBinaryContentAs(byCommand);
    assertThat(folder.resolve("library.units.json"))
        .hasSameBinaryContentAs(folder.resolve("command.units.json"));
    assertThat(Files.size(byLibrary)).isPositive();
  }
}
