package org.mechservice.sim.service.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.NameValue;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;

class SimulationRequestTest {
  private static final SimulationSettings FILE =
      new SimulationSettings(new RunSettings(1, 3, 0.01, "DE", 1e-5, 1e-6), "auto");

  private static SimulationRequest parse(String... pairs) throws InvalidOption {
    NameValue[] options =
        Arrays.stream(pairs)
            .map(pair -> pair.split("=", 2))
            .map(pair -> new NameValue(pair[0], pair[1]))
            .toArray(NameValue[]::new);
    return SimulationRequest.parse(RequestOptions.of(options), FILE);
  }

  @Test
  void absentOptionsMeanAsTheFileSays() throws Exception {
    SimulationRequest options = parse();
    assertThat(options.settings()).isEqualTo(FILE.run());
    assertThat(options.formulation()).isEqualTo("auto");
    assertThat(options.columns()).containsExactly(ColumnGroup.JOINTS);
    assertThat(options.standalone()).isFalse();
  }

  @Test
  void givenOptionsOverrideTheFile() throws Exception {
    SimulationRequest options =
        parse(
            "t-end=2.5",
            "t-step=1e-3",
            "rtol=1.0E-9",
            "atol= 1e-12 ",
            "integrator=ode113",
            "formulation=DTR",
            "columns=energy,bodies",
            "standalone=true");
    assertThat(options.settings()).isEqualTo(new RunSettings(1, 2.5, 1e-3, "ode113", 1e-9, 1e-12));
    assertThat(options.formulation()).isEqualTo("DTR");
    assertThat(options.columns())
        .containsExactlyInAnyOrder(ColumnGroup.JOINTS, ColumnGroup.ENERGY, ColumnGroup.BODIES);
    assertThat(options.standalone()).isTrue();
  }

  @Test
  void codeIsLaidOutAsAsked() throws Exception {
    assertThat(parse().code()).isEqualTo(CodeForm.AUTO);
    assertThat(parse("code=shared").forJar().form()).isEqualTo(CodeForm.SHARED);
  }

  @ParameterizedTest
  @CsvSource({"code=curved, shared", "code=straight;compact=true, leave out one"})
  void codeThatCannotBeLaidOutSoIsRefused(String options, String advice) {
    InvalidOption refused =
        catchThrowableOfType(InvalidOption.class, () -> parse(options.split(";", -1)));
    assertThat(refused.text).contains(advice);
  }

  @Test
  void accuracyIsThatOfTheFileUnlessTheRequestNamesOne() throws Exception {
    assertThat(parse().settings().accuracy()).isEqualTo(Accuracy.STANDARD);
    RunSettings strict =
        parse("accuracy=strict", "rtol=1e-9", "atol=1e-3;1e-4;1e-5;1e-6").settings();
    assertThat(strict.accuracy()).isEqualTo(Accuracy.STRICT);
    SimulationSettings file =
        new SimulationSettings(FILE.run().withAccuracy(Accuracy.STRICT), "auto");
    RequestOptions none = RequestOptions.of(new NameValue[0]);
    assertThat(SimulationRequest.parse(none, file).settings().accuracy())
        .isEqualTo(Accuracy.STRICT);
    NameValue[] asked = {new NameValue("accuracy", "standard")};
    assertThat(SimulationRequest.parse(RequestOptions.of(asked), file).settings().accuracy())
        .isEqualTo(Accuracy.STANDARD);
  }

  @Test
  void automaticIntegratorIsResolved() throws Exception {
    assertThat(parse("integrator=auto").settings().integrator()).isEqualTo("switching");
  }

  @Test
  void columnsOfTheFileHoldUntilOthersAreAskedFor() throws Exception {
    SimulationSettings file =
        new SimulationSettings(
            "",
            FILE.task(),
            FILE.run(),
            FILE.absoluteTolerances(),
            "auto",
            "auto",
            List.of("bodies", "reactions"),
            List.of());
    assertThat(SimulationRequest.parse(RequestOptions.of(new NameValue[0]), file).columns())
        .containsExactlyInAnyOrder(ColumnGroup.JOINTS, ColumnGroup.BODIES, ColumnGroup.REACTIONS);
    NameValue[] asked = {new NameValue("columns", "energy")};
    assertThat(SimulationRequest.parse(RequestOptions.of(asked), file).columns())
        .containsExactlyInAnyOrder(ColumnGroup.JOINTS, ColumnGroup.ENERGY);
  }

  @Test
  void allColumnsAreAllGroups() throws Exception {
    assertThat(parse("columns=all").columns()).containsExactlyInAnyOrder(ColumnGroup.values());
  }

  @Test
  void runsThatDifferInTimesAndTolerancesShareOneClass() throws Exception {
    assertThat(parse("t-end=9", "rtol=1e-9").forRun(FILE)).isEqualTo(parse().forRun(FILE));
    assertThat(parse("t-end=9").forJar()).isNotEqualTo(parse().forJar());
  }

  @ParameterizedTest
  @CsvSource({
    "t-end=0.5, t-end",
    "t-end=soon, t-end",
    "t-end=NaN, t-end",
    "t-end=Infinity, t-end",
    "t-end=2d, t-end",
    "'t-end=', t-end",
    "t-step=0, t-step",
    "t-step=-1, t-step",
    "rtol=0, rtol",
    "rtol=1, rtol",
    "rtol=-1e-3, rtol",
    "atol=0, atol",
    "atol=1e-3;1e-4;1e-5, atol",
    "atol=1e-3;1e-4;1e-5;x, atol",
    "'columns=joints,velocity', columns",
    "standalone=yes, standalone",
    "tolerance=1, tolerance",
    "accuracy=sharp, accuracy",
    "'accuracy=', accuracy"
  })
  void whatCannotBeUsedIsRefusedByName(String option, String name) {
    InvalidOption refusal = catchThrowableOfType(InvalidOption.class, () -> parse(option));
    assertThat(refusal.optionName).isEqualTo(name);
    assertThat(refusal.code).isEqualTo("S-008");
    assertThat(refusal.text).contains(name);
  }

  @Test
  void absoluteTolerancesMayGoByKindOfState() throws Exception {
    RunSettings settings = parse("atol=1e-3;1e-4;1e-5;1e-6").settings();
    assertThat(settings.absoluteTolerance("m")).isEqualTo(1e-3);
    assertThat(settings.absoluteTolerance("rad")).isEqualTo(1e-4);
    assertThat(settings.absoluteTolerance("m/s")).isEqualTo(1e-5);
    assertThat(settings.absoluteTolerance("rad/s")).isEqualTo(1e-6);
    assertThat(settings.hasOneTolerance()).isFalse();
    assertThat(parse("atol=1e-3").settings().hasOneTolerance()).isTrue();
  }

  @Test
  void unknownOptionIsAnsweredWithTheKnownOnes() {
    InvalidOption refusal = catchThrowableOfType(InvalidOption.class, () -> parse("step=1"));
    assertThat(refusal.text).contains("atol, closure, code, columns").contains("t-end, t-step");
  }

  @Test
  void optionGivenTwiceIsRefused() {
    InvalidOption refusal =
        catchThrowableOfType(InvalidOption.class, () -> parse("rtol=1e-3", "rtol=1e-4"));
    assertThat(refusal.text).contains("twice");
  }
}
