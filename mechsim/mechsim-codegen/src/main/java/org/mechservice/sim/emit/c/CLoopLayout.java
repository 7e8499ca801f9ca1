package org.mechservice.sim.emit.c;

import java.util.stream.IntStream;
import org.mechservice.sim.emit.method.NumberText;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.kinematics.StateCoordinates;

/**
 * Writes the constant {@code LOOPS} of a model in C with closed loops: the layout of its equations
 * and the functions of its terms, by which {@code mech_loops.c} solves them.
 */
final class CLoopLayout {
  private final CModel model;
  private final CLoops loops;
  private final String name;
  private final SourceLines source;
  private final CArrays arrays;
  private final NumberText numbers;

  CLoopLayout(CModel model, CLoops loops, SourceLines source, CArrays arrays, NumberText numbers) {
    this.model = model;
    this.loops = loops;
    this.name = model.name();
    this.source = source;
    this.arrays = arrays;
    this.numbers = numbers;
  }

  void write() {
    callback("void", "loop_terms", "terms");
    callback("int", "all_terms", "terms");
    callback("void", "mass_matrix", "terms");
    tangentCallback(CPrograms.TANGENT);
    loops.further().ifPresent(program -> tangentCallback(CPrograms.FURTHER_TANGENT));
    loops.further().ifPresent(program -> callback("void", "further_rates", "rates"));
    loops.angles().ifPresent(program -> callback("void", "cut_angles", "angles"));
    layout();
  }

  private void layout() {
    StateCoordinates coordinates = new StateCoordinates(model.mechanism());
    int nq = coordinates.positionCount();
    int nv = coordinates.velocityCount();
    int balls = coordinates.ballCount();
    arrays.integers("LOOP_START", loops.rowStart());
    arrays.integers("LOOP_COLUMN", loops.column());
    arrays.integers(
        "VELOCITY_OF", IntStream.range(0, nq).map(coordinates::velocityOf).boxed().toList());
    arrays.integers(
        "POSITION_OF", IntStream.range(0, nv).map(coordinates::positionOf).boxed().toList());
    arrays.integers(
        "BALL_Q", IntStream.range(0, balls).map(coordinates::ballPosition).boxed().toList());
    arrays.integers(
        "BALL_V", IntStream.range(0, balls).map(coordinates::ballVelocity).boxed().toList());
    arrays.doubles("UNIT", loops.unit());
    arrays.doubles("SIZE", loops.size());
    arrays.doubles("PLACE_ROUNDING", loops.placeRounding());
    if (loops.angles().isPresent()) {
      arrays.doubles("ANGLE_STARTS", loops.angleStarts());
    }
    source.line("static const mech_loops LOOPS = {");
    int further = model.states().size() - nq - nv;
    source.line(
        "    %d, %d, %d, %d, %d, %d, LOOP_START, LOOP_COLUMN, VELOCITY_OF, POSITION_OF,"
            .formatted(
                nq, nv, further, loops.angleStarts().size(), loops.rows(), loops.column().size()));
    PenaltySettings penalty = loops.penalty();
    source.line(
        "    %d, BALL_Q, BALL_V, UNIT, SIZE, PLACE_ROUNDING, %s, %s, %s, REGULAR,"
            .formatted(
                balls,
                numbers.of(penalty.stiffness()),
                numbers.of(penalty.frequency()),
                numbers.of(penalty.damping())));
    source.line(
        "    loop_terms_of, all_terms_of, mass_matrix_of, %s, %s, %s_of, %s"
            .formatted(
                loops.further().isPresent() ? "further_rates_of" : "NULL",
                loops.angles().isPresent() ? "cut_angles_of" : "NULL",
                CPrograms.TANGENT,
                loops.further().isPresent() ? CPrograms.FURTHER_TANGENT + "_of" : "NULL"));
    source.line("};").blank();
  }

  private void tangentCallback(String function) {
    source.open(
        "static void "
            + function
            + "_of(void *model, double t, const double *y, const double *given,"
            + " const double *seed, double *rates)");
    source.line(function + "((" + name + "_t *)model, t, y, given, seed, rates);");
    source.close().blank();
  }

  private void callback(String result, String function, String output) {
    source.open(
        "static %s %s_of(void *model, double t, const double *y, double *%s)"
            .formatted(result, function, output));
    String call = "%s((%s_t *)model, t, y, %s);".formatted(function, name, output);
    source.line(result.equals("void") ? call : "return " + call);
    source.close().blank();
  }
}
