package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A block on a slide, and what is told of the events of a file: an event or a note, never silence.
 */
class EventsToldTest {
  private static MechModel slider(
      double end, double q, double v, double force, String tables, String states, String events)
      throws MechmlException {
    String text =
        "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='"
            + end
            + "' tstep='0.5'/><integrator name='auto' relTol='1e-8' absTol='1e-10'/>"
            + events
            + "</dynamic></MBSsimulation><MBSmodel name='Slider' massUnits='kg' lengthUnits='m'"
            + " silence='no-gravity'>"
            + tables
            + "<Bodies><body name='ground'/><body name='block'><mass value='1'/></body></Bodies>"
            + "<Joints><joint name='slide' type='P' body1='ground' body2='block' axis='1;0;0'/>"
            + "</Joints>"
            + states
            + "<Forces><jointForce name='push' joint='slide' expression='"
            + (tables.isEmpty() ? Double.toString(force) : "tb(t)")
            + "'/></Forces><topology><root name='ground'/><relCoorVals><jointVal name='slide'"
            + " posVals='"
            + q
            + "' velVals='"
            + v
            + "'/></relCoorVals></topology></MBSmodel></MechML>";
    return MechModel.of("slider.xml", text);
  }

  private static String event(String expression, String direction, String action) {
    return "<event name='e' expression='"
        + expression
        + "' direction='"
        + direction
        + "' action='"
        + action
        + "'/>";
  }

  private static List<Note> notes(Trajectory motion, MessageCode code) {
    return motion.report().notes().stream().filter(note -> note.code() == code).toList();
  }

  @ParameterizedTest
  @CsvSource({"ode113, rising", "DE, both", "ode15s, rising", "ode15sR, both", "auto, rising"})
  void stopAtAnExpressionThatIsFlatZeroBefore(String integrator, String direction)
      throws MechmlException {
    MechModel model =
        slider(4, 5, 0, -9.81, "", "", event("max(0, 1 - slide.q)", direction, "stop"));
    Trajectory motion = model.integrator(integrator).simulate();
    List<Note> events = notes(motion, MessageCode.EVENT_OCCURRED);
    assertThat(events).hasSize(1);
    assertThat(events.get(0).time()).isCloseTo(Math.sqrt(2 * 4 / 9.81), within(1e-6));
    assertThat(notes(motion, MessageCode.EVENT_NOT_COUNTED)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"slide.q - 2, rising", "2 - slide.q, falling", "slide.q^2 - 4, rising"})
  void limitThatIsPassedAtTheStartIsTold(String expression, String direction)
      throws MechmlException {
    Trajectory motion = slider(2, 3, 1, 0, "", "", event(expression, direction, "stop")).simulate();
    assertThat(notes(motion, MessageCode.EVENT_OCCURRED)).isEmpty();
    assertThat(notes(motion, MessageCode.EVENT_NOT_COUNTED))
        .singleElement()
        .satisfies(note -> assertThat(note.text()).contains("at the start, beyond zero"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"1/(slide.q - 0.7)", "tan(slide.q - 0.7 + PI/2)"})
  void poleIsNoEventAndIsTold(String expression) throws MechmlException {
    Trajectory motion = slider(2, 0, 1, 0, "", "", event(expression, "both", "record")).simulate();
    assertThat(notes(motion, MessageCode.EVENT_OCCURRED)).isEmpty();
    assertThat(notes(motion, MessageCode.EVENT_NOT_COUNTED))
        .singleElement()
        .satisfies(note -> assertThat(note.text()).contains("changes its sign through infinity"))
        .satisfies(note -> assertThat(note.time()).isCloseTo(0.7, within(1e-9)));
  }

  @ParameterizedTest
  @CsvSource({"abs(slide.q - 0.7), both", "(slide.q - 0.7)^2, falling", "-(slide.q-0.7)^2, rising"})
  void touchIsNoEventAndIsTold(String expression, String direction) throws MechmlException {
    Trajectory motion = slider(2, 0, 1, 0, "", "", event(expression, direction, "stop")).simulate();
    assertThat(notes(motion, MessageCode.EVENT_OCCURRED)).isEmpty();
    assertThat(notes(motion, MessageCode.EVENT_NOT_COUNTED))
        .singleElement()
        .satisfies(note -> assertThat(note.text()).contains("comes to zero", "turns back"))
        // Of the square nothing below 1e-8 of its size is known: 1e-4 of the way.
        .satisfies(note -> assertThat(note.time()).isCloseTo(0.7, within(2e-4)));
  }

  /** A sample at the very end, where the table of the force ends too. */
  @Test
  void sampleAtTheEndNeedsNothingBehindIt() throws MechmlException {
    MechModel model =
        slider(
            2,
            0,
            0,
            0,
            "<Tables><table name='tb' x='0;1;2' y='0;1;0'/></Tables>",
            "<States><sampled name='s' period='0.1' value='s + slide.q'/></States>",
            "");
    Trajectory motion = model.simulate();
    double[] q = motion.column("slide.q");
    // Up to 1 s the force is t, then 2 - t: q = 1/6 at 1 s, 1/6 + 1/2 + 1/3 at 2 s.
    assertThat(q[q.length - 1]).isCloseTo(1, within(1e-7));
    // The row at the time of a sample has the values before it.
    double sum = 0;
    for (int k = 1; k < 20; k++) {
      double t = 0.1 * k;
      double behind = t - 1;
      sum +=
          t <= 1
              ? t * t * t / 6
              : 1 / 6.0 + behind / 2 + behind * behind / 2 - behind * behind * behind / 6;
    }
    double[] s = motion.column("s");
    assertThat(s[s.length - 1]).isCloseTo(sum, within(1e-6));
  }
}
