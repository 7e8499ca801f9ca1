package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.catalogue.MessageCode;

/** Warnings before a run and during a run are silenced by their names or codes. */
class SilencedWarningsTest {
  /** Its loop has three redundant equations. */
  private static final Path FOUR_BAR = Path.of("../examples/extremes/fourbar_redundant.xml");

  /** Its start is moved by 1 cm to close the loop. */
  private static final Path OPEN = Path.of("../examples/extremes/start_off_1e-2.xml");

  private static Set<MessageCode> noted(MechModel model) {
    return model.simulate().report().notes().stream()
        .map(note -> note.code())
        .collect(Collectors.toSet());
  }

  @Test
  void silencedWarningsAreNeitherInTheCheckNorInTheReportOfTheRun() throws Exception {
    MechModel model = MechModel.read(FOUR_BAR).until(0.01);
    MechModel silent = model.silence("loops-redundant").silence("N-044");

    assertThat(model.check().warnings()).singleElement().asString().contains("S-090");
    assertThat(silent.check().warnings()).isEmpty();
    assertThat(noted(model)).containsExactly(MessageCode.REDUNDANT_CONSTRAINTS);
    assertThat(noted(silent)).isEmpty();
  }

  @Test
  void strictRunsGoOnAfterSilencedWarnings() throws Exception {
    MechModel strict = MechModel.read(OPEN).until(0.01).strict();

    assertThatThrownBy(strict::simulate).isInstanceOf(RunFailedException.class);
    assertThat(strict.silence("start-position-corrected").simulate().time()).isNotEmpty();
  }

  @Test
  void wordsThatAreNoWarningsAreRefused() throws Exception {
    MechModel model = MechModel.read(FOUR_BAR);

    assertThatThrownBy(() -> model.silence("no-gravty"))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining("did you mean \"no-gravity\"?");
  }
}
