package org.mechservice.sim.emit.c;

import java.util.List;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.solver.api.capability.ModelEvents;

/**
 * Writes what changes a model in C at an instant: jumps of its equations at known times, impulses
 * of prescribed velocities that jump, samples, and events.
 */
final class CJumps {
  private final CModel model;
  private final CEvents events;
  private final String name;
  private final SourceLines source;
  private final CArrays arrays;
  private final int eventCount;
  private final int changeCount;

  CJumps(CModel model, SourceLines source, CArrays arrays) {
    this.model = model;
    this.events = model.events();
    this.name = model.name();
    this.source = source;
    this.arrays = arrays;
    this.eventCount = events.kinds().size();
    this.changeCount = eventCount + events.samplings().size();
  }

  private void open(String result, String function, String parameters) {
    source.blank().open(result + name + "_" + function + "(" + parameters + ")");
  }

  private String instance() {
    return name + "_t *m";
  }

  /** Writes the times, and on which side of a jump of the equations they are evaluated. */
  void times() {
    List<CEvents.Jump> jumps = events.jumps();
    List<CEvents.Sampled> samplings = events.samplings();
    source.line("/* Times closer than this are one. */");
    source.open("static double margin(double t)");
    source.line("return 4 * DBL_EPSILON * fabs(t) + DBL_MIN;").close().blank();
    if (!jumps.isEmpty()) {
      arrays.doubles("JUMPS", jumps.stream().map(CEvents.Jump::time).toList());
      source.line("enum { JUMP_COUNT = " + jumps.size() + " };").blank();
      source.line("/* Time on the side of a jump on which the run is: at the jump both meet. */");
      source.open("static double beside(const " + instance() + ", double t)");
      source.line("int first = (int)mech_interval(JUMPS, JUMP_COUNT, t) - 1;");
      source.open("for (int i = first < 0 ? 0 : first; i < JUMP_COUNT && i <= first + 1; i++)");
      source.line("double near = margin(JUMPS[i]);");
      source.open("if (fabs(t - JUMPS[i]) < near)");
      source.line("return m->went_on >= JUMPS[i] ? JUMPS[i] + near : JUMPS[i] - near;");
      source.close().close();
      source.line("return t;").close().blank();
    }
    if (!samplings.isEmpty()) {
      arrays.doubles("PERIOD", samplings.stream().map(CEvents.Sampled::period).toList());
      arrays.doubles("OFFSET", samplings.stream().map(CEvents.Sampled::offset).toList());
      source.line("enum { SAMPLING_COUNT = " + samplings.size() + " };").blank();
      source.line("/* First sample of a sampling after t. */");
      source.open("static double next_sample(int i, double t)");
      source.line("double k = floor((t - OFFSET[i]) / PERIOD[i]) - 1;");
      source.open("while (!(OFFSET[i] + k * PERIOD[i] > t))");
      source.line("k++;").close();
      source.line("return OFFSET[i] + k * PERIOD[i];").close().blank();
    }
    open("double ", "next_jump", "const " + instance() + ", double t");
    source.line("double after = t > m->went_on ? t : m->went_on, next = HUGE_VAL;");
    if (!jumps.isEmpty()) {
      source.line("int ahead = (int)mech_interval(JUMPS, JUMP_COUNT, after);");
      source.open("if (ahead < JUMP_COUNT)");
      source.line("next = JUMPS[ahead];").close();
    }
    if (!samplings.isEmpty()) {
      source.open("for (int i = 0; i < SAMPLING_COUNT; i++)");
      source.line("double sample = next_sample(i, after);");
      source.open("if (sample < next)").line("next = sample;").close().close();
    }
    if (jumps.isEmpty() && samplings.isEmpty()) {
      source.line("(void)after;");
    }
    source.line("return next;").close();
  }

  /** Writes the changes of the state by events, by samples and by impulses. */
  void changes() {
    if (!events.assignments().isEmpty()) {
      assign();
    }
    boolean impulses = events.jumps().stream().anyMatch(CEvents.Jump::impulse);
    if (impulses) {
      impulse();
    }
    instants(impulses);
    eventValues();
    event();
  }

  /** Writes what sets components to values that are all those before the change. */
  private void assign() {
    int count = events.assignments().size();
    arrays.integers("EVENT", events.assignments().stream().map(a -> a.event()).toList());
    arrays.integers("COMPONENT", events.assignments().stream().map(a -> a.component()).toList());
    source
        .blank()
        .line("/* Sets what the changes that count assign; returns whether there is any. */");
    source.open(
        "static int assign("
            + instance()
            + ", const unsigned char *counts, double t, double *x, unsigned char *set)");
    source.line("double values[" + count + "];");
    source.line("int changed = 0;");
    source.line("assigned(m, t, " + state("x") + ", values);");
    source.open("for (int i = 0; i < " + count + "; i++)");
    source.open("if (counts[EVENT[i]])");
    source.line("x[COMPONENT[i]] = values[i];");
    source.line("set[COMPONENT[i]] = 1;");
    source.line("changed = 1;").close().close();
    source.line("return changed;").close();
  }

  private String state(String x) {
    return model.hasAngles() ? "mech_loops_state(&LOOPS, m->loop, " + x + ")" : x;
  }

  /**
   * Writes the change of the free velocities by the impulse of a drive: the momenta of the free
   * coordinates, M_ff v_f + M_fd v_d, are the same before and after it. They are the derivatives of
   * the kinetic energy by the velocities; as it is quadratic, differences give them to rounding.
   */
  private void impulse() {
    int positions = model.description().positionCount();
    int velocities = model.description().velocityCount();
    source.blank();
    source.line(
        "enum { FIRST_V = " + positions + ", NV = " + velocities + ", NO_IMPULSE = 2000001 };");
    source.blank().open("static double kinetic(" + instance() + ", double t, const double *x)");
    source.line("double energy[2];");
    source.line(COutputs.ENERGIES + "(m, beside(m, t), " + state("x") + ", energy);");
    source.line("return energy[0];").close();
    source.blank().line("/* Derivatives of the kinetic energy by the free velocities. */");
    source.open("static void momenta(" + instance() + ", double t, const double *x, double *p)");
    source.line("double y[" + name + "_NX];");
    source.line("memcpy(y, x, sizeof y);");
    source.open("for (int k = 0; k < NV; k++)");
    source.line("double v = x[FIRST_V + k], h = 1 + fabs(v), above;");
    source.line("y[FIRST_V + k] = v + h;");
    source.line("above = kinetic(m, t, y);");
    source.line("y[FIRST_V + k] = v - h;");
    source.line("p[k] = (above - kinetic(m, t, y)) / (2 * h);");
    source.line("y[FIRST_V + k] = v;").close().close();
    source
        .blank()
        .line("/* Velocities with which the momenta are p; returns whether there are any. */");
    source.open("static int push(" + instance() + ", double t, double *x, const double *p)");
    source.line("static const int ROUNDS = 3;");
    source.line("double y[" + name + "_NX], mass[NV * NV], own[NV], now[NV], zero;");
    source.line("memcpy(y, x, sizeof y);");
    source.line("memset(y + FIRST_V, 0, sizeof now);");
    source.line("zero = kinetic(m, t, y);");
    source.open("for (int k = 0; k < NV; k++)");
    source.line("y[FIRST_V + k] = 1;");
    source.line("own[k] = kinetic(m, t, y);");
    source.open("for (int j = 0; j < k; j++)");
    source.line("y[FIRST_V + j] = 1;");
    source.line("mass[k * NV + j] = kinetic(m, t, y) - own[k] - own[j] + zero;");
    source.line("y[FIRST_V + j] = 0;").close();
    source.line("y[FIRST_V + k] = -1;");
    source.line("mass[k * NV + k] = own[k] - 2 * zero + kinetic(m, t, y);");
    source.line("y[FIRST_V + k] = 0;").close();
    source.line("/* L of M = L L' in its place */");
    source.open("for (int i = 0; i < NV; i++)");
    source.open("for (int j = 0; j <= i; j++)");
    source.line("double sum = mass[i * NV + j];");
    source.open("for (int k = 0; k < j; k++)");
    source.line("sum -= mass[i * NV + k] * mass[j * NV + k];").close();
    source.open("if (j == i && !(sum > 64 * DBL_EPSILON * fabs(mass[i * NV + i])))");
    source.line("return 0;").close();
    source.line("mass[i * NV + j] = j == i ? sqrt(sum) : sum / mass[j * NV + j];");
    source.close().close();
    source.open("for (int round = 0; round < ROUNDS; round++)");
    source.line("momenta(m, t, x, now);");
    source.open("for (int i = 0; i < NV; i++)");
    source.line("now[i] = p[i] - now[i];");
    source.open("for (int k = 0; k < i; k++)");
    source.line("now[i] -= mass[i * NV + k] * now[k];").close();
    source.line("now[i] /= mass[i * NV + i];").close();
    source.open("for (int i = NV - 1; i >= 0; i--)");
    source.open("for (int k = i + 1; k < NV; k++)");
    source.line("now[i] -= mass[k * NV + i] * now[k];").close();
    source.line("now[i] /= mass[i * NV + i];");
    source.line("x[FIRST_V + i] += now[i];").close().close();
    source.line("return 1;").close();
  }

  /** Writes the changes at known times: at the start samples alone. */
  private void instants(boolean impulses) {
    boolean samples = !events.samplings().isEmpty();
    if (samples || impulses) {
      source
          .blank()
          .open("static int instant(" + instance() + ", double t, double *x, int starts)");
      source.line("unsigned char set[" + name + "_NX] = {0};");
      source.line("int changed = 0;");
      if (samples) {
        source.line("unsigned char counts[" + changeCount + "] = {0};");
      }
      if (impulses) {
        arrays.bytes("PUSHES", events.jumps().stream().map(j -> j.impulse() ? 1 : 0).toList());
        source.line("double p[NV];");
        source.line("int pushed = 0;");
        source.open("for (int i = 0; i < JUMP_COUNT && !starts; i++)");
        source.line(
            "pushed |= PUSHES[i] && JUMPS[i] > m->went_on && fabs(JUMPS[i] - t) <= margin(t);");
        source.close();
        source.open("if (pushed)").line("momenta(m, t, x, p);").close();
      } else {
        source.line("(void)starts;");
      }
      if (samples) {
        source.open("for (int i = 0; i < SAMPLING_COUNT; i++)");
        source.line("double due = next_sample(i, t - margin(t));");
        source.line(
            "counts[%d + i] = due > m->went_on && due <= t + margin(t);".formatted(eventCount));
        source.close();
      }
      source.line("m->went_on = t + margin(t);");
      if (impulses) {
        source.open("if (pushed && !push(m, t, x, p))");
        source.line("m->failure = NO_IMPULSE;").line("return -1;").close();
        source.line("changed |= pushed;");
      }
      if (samples) {
        source.line("changed |= assign(m, counts, t, x, set);");
      }
      source.open("if (changed && " + name + "_close(m, t, x, set) < 0)");
      source.line("return -1;").close();
      source.line("return changed;").close();
    }
    open("int ", "begin", instance() + ", double t, double *x");
    instantBody(samples || impulses, 1);
    open("int ", "go_on", instance() + ", double t, double *x");
    instantBody(samples || impulses, 0);
  }

  private void instantBody(boolean changes, int starts) {
    if (changes) {
      model.inputLines().forEach(source::line);
      source.line("return instant(m, t, x, " + starts + ");").close();
    } else {
      source.line("(void)x;").line("m->went_on = t + margin(t);").line("return 0;").close();
    }
  }

  private void eventValues() {
    open("int ", "event_values", instance() + ", double t, const double *x, double *g");
    if (eventCount == 0) {
      source.line("(void)m;").line("(void)t;").line("(void)x;").line("(void)g;");
    } else {
      model.placeLines().forEach(source::line);
      source.line("triggers(m, t, " + state("x") + ", g);");
    }
    source.line("return 0;").close();
  }

  private void event() {
    open("int ", "event", instance() + ", const signed char *occurred, double t, double *x");
    if (eventCount == 0) {
      source.line("(void)m;").line("(void)occurred;").line("(void)t;").line("(void)x;");
      source.line("return 0;").close();
      return;
    }
    source.line("/* Sense of the crossings that count: +1 rising, -1 falling, 0 both. */");
    arrays.bytes("SENSE", events.kinds().stream().map(CJumps::sense).toList());
    arrays.bytes(
        "ENDS",
        events.kinds().stream()
            .map(kind -> kind.action() == ModelEvents.Action.STOP ? 1 : 0)
            .toList());
    boolean changes =
        events.assignments().stream().anyMatch(assignment -> assignment.event() < eventCount);
    source.line("unsigned char counts[" + changeCount + "] = {0};");
    source.line("int ends = 0;");
    if (changes) {
      source.line("unsigned char set[" + name + "_NX] = {0};");
      source.line("int changed;");
    }
    source.open("for (int i = 0; i < " + eventCount + "; i++)");
    source.line("counts[i] = occurred[i] != 0 && SENSE[i] * occurred[i] >= 0;");
    source.line("ends |= counts[i] && ENDS[i];").close();
    if (changes) {
      model.placeLines().forEach(source::line);
      source.line("changed = assign(m, counts, t, x, set);");
      source.open("if (changed && " + name + "_close(m, t, x, set) < 0)");
      source.line("return -1;").close();
      source.line("return (ends ? 2 : 0) + changed;").close();
    } else {
      source.line("(void)m;").line("(void)t;").line("(void)x;");
      source.line("return ends ? 2 : 0;").close();
    }
  }

  private static int sense(ModelEvents.Kind kind) {
    return switch (kind.direction()) {
      case RISING -> 1;
      case FALLING -> -1;
      case BOTH -> 0;
    };
  }
}
