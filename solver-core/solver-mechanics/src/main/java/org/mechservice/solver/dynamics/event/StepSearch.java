package org.mechservice.solver.dynamics.event;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.TapePieces;

/**
 * Searches an accepted step for what its ends do not show: a choice in the formulas that is taken
 * otherwise inside the step, or a formula that is larger there than its values at the ends tell.
 *
 * <p>The formulas are evaluated on the interpolated solution, which costs kinematics and no
 * dynamics, at the ends and in the middle of a part of the step in which no body turns by more than
 * {@value #TURN} rad relative to another. {@link TapePieces} decides from these three points
 * whether any choice that matters can change in the part. What is open is halved, down to the
 * resolution of time.
 *
 * <p>A change that the error test cannot have seen ends the step just behind it. A change that
 * shows at the end of the step ends it, too, so that the method begins anew on the other side; if
 * this happens {@value #MOST_CLOSE} times in close succession, the choice hovers about its
 * boundary, and such changes are left to the error test.
 *
 * <p>Workspace of one run; nothing allocates in a step.
 */
final class StepSearch {
  /** Largest turn of a body relative to another in a part of a step, rad. */
  private static final double TURN = 0.5;

  /** Margin of a way beside three points of it, relative to their second difference. */
  private static final double MARGIN = 0.5;

  /** Most evaluations in a step beyond its first division, after which halving ends. */
  private static final int MOST_EVALUATIONS = 4000;

  /** Most parts of the first division. */
  private static final int MOST_PARTS = 1_000_000;

  /** Depth of halving: the resolution of time within a step. */
  private static final int DEPTH = 44;

  /** Width to which a change is narrowed down, in units of the last place of time. */
  private static final double RESOLUTION = 4;

  /** Farthest place behind a change at which a step is cut, in these widths. */
  private static final double FARTHEST = 64;

  /** Distance from a boundary, relative to the size of the argument, beyond rounding. */
  private static final double CLEAR = 1e-14;

  /** Roundings of t within which a change lies that steps cannot cross. */
  private static final double ROUNDINGS = 16_384;

  /**
   * Way beyond a boundary that is a touch, relative to the largest size that the argument has had:
   * where a step begins on a boundary, rounding takes it to one side or the other.
   */
  private static final double TOUCH = 1e-12;

  /** Depth to which the first way to a hidden value is followed. */
  private static final int FORMULA_DEPTH = 20;

  /** Steps within which two changes of a choice follow each other closely. */
  private static final int CLOSE = 10;

  /** Close changes in a row after which those that show are left to the error test. */
  private static final int MOST_CLOSE = 8;

  /** Steps in a row after which it is asked whether the solution slides along a jump. */
  private static final int ROW = 2000;

  /** Changes in them, or steps beside one, from which on it may. */
  private static final int CHANGES = 20;

  /** Distance from the boundary, relative to the size of the argument, that it keeps then. */
  private static final double HOVERING = 1e-6;

  /** The same for changes that do not show, which is next to never. */
  private static final int MOST_HIDDEN = 400;

  /** Size of a formula, relative to the largest value it has had, that does not matter. */
  private static final double NOTHING = 1e-10;

  /**
   * Growth of a box beside a step, in lengths of the step's way: at most, at least, and between.
   */
  private static final double LARGE_BOX = 16;

  private static final double SMALL_BOX = 1;
  private static final double SHRINKAGE = 0.25;

  /** Most steps after which a box is sought again where there was none, or one of no use. */
  private static final double LONGEST_PAUSE = 15;

  /** Growth of the box in which a change counts as beside the step: one of those tried. */
  private static final double BESIDE = 4;

  /** Part of the way to a hidden value that the first step behind takes. */
  private static final double FIRST_STEP = 0.25;

  private final Quantities quantities;
  private final TapePieces pieces;
  private final int leaves;
  private final int[][] turns;
  private final double[][] scratch;
  private final double[] atFrom;
  private final double[] atMiddle;

  /** Whether the point in the middle of the step has been evaluated. */
  private boolean middleKnown;

  private final double[] atTo;
  private final double[] moving;
  private final double[] narrowing;

  /** Quantities at the point looked at. */
  private final double[] here;

  /** Fastest turn at the ends of the step, rad/s. */
  private double turning;

  private final double[] sizes;
  private final double[] piecesFrom;
  private final double[] piecesTo;
  private final double[] valueFrom;
  private final double[] valueTo;
  private final double[] valueBefore;
  private final double[] largest;

  /** Whether formulas that do not show are only looked at, and whether one was found. */
  private boolean looking;

  private boolean hidden;

  private final double[] sinceChange;
  private final double[] closeChanges;

  /** Of each choice, the piece it took before its last change. */
  private final double[] left;

  /** Of each choice in the row of steps: largest distance from its boundary, and changes. */
  private final double[] farthest;

  private final double[] changes;

  /** Where the sign of an event changes first, if that shows; NaN if it has not yet. */
  private final double[] firstSeen;

  private final double[] boxLow;
  private final double[] boxHigh;

  /** Whether nothing changes its form in the box. */
  private boolean boxed;

  /** Steps for which no box is sought, and how many are left of them. */
  private double pause;

  private double pauseLeft;

  private final OverlapMonitor overlaps;

  /** Where a step was first accepted without being searched to its end, and how many there are. */
  private double unsearched = Double.NaN;

  private long unsearchedCount;
  private boolean gaveUp;

  private double begin;
  private double finish;
  private int evaluations;
  private int allowed;
  private double longestFirstStep = Double.POSITIVE_INFINITY;
  private double slidingSince = Double.NaN;

  private double stepsInRow;
  private double rowBegan;
  private boolean begun;

  /** Evaluates the watched quantities. */
  interface Quantities {
    /** Writes the quantities at a state. */
    void evaluate(double t, double[] y, double[] values);
  }

  StepSearch(WatchedTape watched, Quantities quantities) {
    this.quantities = quantities;
    overlaps = new OverlapMonitor(watched.overlaps(), watched.quantities());
    pieces = new TapePieces(watched.tape(), watched.formulaCount());
    leaves = watched.tape().leaves().size();
    turns = watched.turns().toArray(int[][]::new);
    int count = watched.quantities().size();
    boxLow = new double[leaves];
    boxHigh = new double[leaves];
    here = new double[count];
    scratch = new double[DEPTH + 1][];
    Arrays.setAll(scratch, depth -> pieces.newPoint());
    atFrom = pieces.newPoint();
    atMiddle = pieces.newPoint();
    atTo = pieces.newPoint();
    moving = pieces.newPoint();
    narrowing = pieces.newPoint();
    int choices = pieces.choiceCount();
    sizes = new double[choices];
    piecesFrom = new double[choices];
    piecesTo = new double[choices];
    sinceChange = new double[choices];
    closeChanges = new double[choices];
    left = new double[choices];
    Arrays.fill(left, Double.NaN);
    Arrays.fill(sinceChange, CLOSE);
    firstSeen = new double[choices];
    farthest = new double[choices];
    changes = new double[choices];
    int formulas = pieces.formulaCount();
    valueFrom = new double[formulas];
    valueTo = new double[formulas];
    valueBefore = new double[formulas];
    largest = new double[formulas];
  }

  /** Begins at a state without history. */
  void begin() {
    begun = false;
  }

  /** Returns the longest first step from where the last search has ended a step, s. */
  double longestFirstStep() {
    return longestFirstStep;
  }

  /**
   * Searches a step.
   *
   * @param path the interpolated solution in the step
   * @return where the step has to end, at most {@code to}; NaN if it may stand
   */
  double search(double from, double to, ModelEvents.Path path) {
    begin = from;
    finish = to;
    gaveUp = false;
    longestFirstStep = Double.POSITIVE_INFINITY;
    evaluations = 0;
    turning = 0;
    middleKnown = false;
    if (!evaluate(path, from, atFrom)) {
      return Double.NaN;
    }
    overlaps.look(from, here);
    if (!evaluate(path, to, atTo)) {
      return Double.NaN;
    }
    if (staysInBox(path, from, to)) {
      begun = false;
      passStep();
      return Double.NaN;
    }
    double end = searchAll(path, from, to);
    boolean seen = Double.isNaN(end);
    if (seen) {
      findBox(path, from, to);
    }
    boxed &= seen;
    passStep();
    return end;
  }

  private void passStep() {
    lookForSliding();
    for (int c = 0; c < sinceChange.length; c++) {
      sinceChange[c] = Math.min(CLOSE, sinceChange[c] + 1);
    }
  }

  /**
   * Returns whether the quantities stay, in the whole step, in a box in which nothing changes its
   * form.
   */
  private boolean staysInBox(ModelEvents.Path path, double from, double to) {
    if (!boxed || parts(to - from) > 1 || !evaluateMiddle(path, from, to)) {
      return false;
    }
    for (int leaf = 0; leaf < leaves; leaf++) {
      double a = pieces.leaf(leaf, atFrom);
      double m = pieces.leaf(leaf, atMiddle);
      double b = pieces.leaf(leaf, atTo);
      double bow = MARGIN * Math.abs(a - 2 * m + b);
      if (Math.min(a, Math.min(m, b)) - bow < boxLow[leaf]
          || Math.max(a, Math.max(m, b)) + bow > boxHigh[leaf]) {
        return false;
      }
    }
    pause = 0;
    return true;
  }

  private boolean evaluateMiddle(ModelEvents.Path path, double from, double to) {
    middleKnown = middleKnown || evaluate(path, 0.5 * (from + to), atMiddle);
    return middleKnown;
  }

  /** Finds a box for the steps to come, if nothing changes its form in one about this step. */
  private void findBox(ModelEvents.Path path, double from, double to) {
    if (boxed) {
      boxed = false;
      pauseLeft = pause;
    }
    if (pauseLeft > 0) {
      pauseLeft--;
      return;
    }
    if (parts(to - from) > 1 || !evaluateMiddle(path, from, to)) {
      return;
    }
    for (double growth = LARGE_BOX; !boxed && growth >= SMALL_BOX; growth *= SHRINKAGE) {
      for (int leaf = 0; leaf < leaves; leaf++) {
        double a = pieces.leaf(leaf, atFrom);
        double m = pieces.leaf(leaf, atMiddle);
        double b = pieces.leaf(leaf, atTo);
        double least = Math.min(a, Math.min(m, b));
        double most = Math.max(a, Math.max(m, b));
        double beside = growth * (most - least) + MARGIN * Math.abs(a - 2 * m + b);
        boxLow[leaf] = least - beside;
        boxHigh[leaf] = most + beside;
        pieces.setLeaf(leaf, boxLow[leaf], boxHigh[leaf]);
      }
      boxed = pieces.decide() && pieces.isEven();
      for (int k = 0; growth == BESIDE && k < pieces.undecidedCount(); k++) {
        changes[pieces.undecided(k)]++;
      }
    }
    pause = Math.min(LONGEST_PAUSE, 2 * pause + 1);
    pauseLeft = pause;
  }

  /** Returns where a step has to end; NaN if it may stand. */
  private double searchAll(ModelEvents.Path path, double from, double to) {
    read(atFrom, piecesFrom, valueFrom);
    if (!begun) {
      System.arraycopy(valueFrom, 0, valueBefore, 0, valueFrom.length);
      begun = true;
    }
    read(atTo, piecesTo, valueTo);
    for (int r = 0; r < largest.length; r++) {
      largest[r] = Math.max(largest[r], Math.max(Math.abs(valueFrom[r]), Math.abs(valueTo[r])));
    }
    int parts = parts(to - from);
    Arrays.fill(firstSeen, Double.NaN);
    allowed = 2 * parts + MOST_EVALUATIONS;
    looking = true;
    hidden = false;
    double end = searchParts(path, from, to, parts);
    if (hidden) {
      // once more, now that it is known how large the formulas become
      looking = false;
      evaluations = 0;
      Arrays.fill(firstSeen, Double.NaN);
      double last = Double.isNaN(end) ? to : end;
      finish = last;
      middleKnown = false;
      if (evaluate(path, last, atTo)) {
        double before = searchParts(path, from, last, parts);
        end = Double.isNaN(before) ? end : before;
      }
    }
    begun = Double.isNaN(end);
    if (begun) {
      System.arraycopy(valueFrom, 0, valueBefore, 0, valueFrom.length);
    }
    return end;
  }

  private void read(double[] point, double[] taken, double[] values) {
    for (int choice = 0; choice < taken.length; choice++) {
      taken[choice] = pieces.piece(choice, point);
    }
    for (int r = 0; r < values.length; r++) {
      values[r] = pieces.value(r, point);
    }
  }

  private boolean evaluate(ModelEvents.Path path, double t, double[] point) {
    evaluations++;
    if (!path.moveTo(t)) {
      return false;
    }
    quantities.evaluate(t, path.state(), here);
    pieces.at(here, point);
    for (int[] group : turns) {
      double turn = 0;
      for (int rate : group) {
        turn += Math.abs(here[rate]);
      }
      turning = Math.max(turning, turn);
    }
    return true;
  }

  /** Returns into how many parts a step is divided, so that bodies turn little in each. */
  private int parts(double h) {
    double parts = Math.ceil(turning * h / TURN);
    return parts >= 1 ? (int) Math.min(MOST_PARTS, parts) : 1;
  }

  private double searchParts(ModelEvents.Path path, double from, double to, int parts) {
    if (parts == 1) {
      return evaluateMiddle(path, from, to)
          ? searchPart(path, 0, from, atFrom, atMiddle, to, atTo)
          : Double.NaN;
    }
    middleKnown = false;
    System.arraycopy(atFrom, 0, moving, 0, moving.length);
    double[] next = atMiddle;
    double start = from;
    for (int k = 1; k <= parts; k++) {
      double end = k == parts ? to : from + (to - from) * k / parts;
      if (!evaluate(path, end, next)) {
        return Double.NaN;
      }
      double found = searchPart(path, 0, start, moving, end, next);
      if (!Double.isNaN(found)) {
        return found;
      }
      System.arraycopy(next, 0, moving, 0, moving.length);
      start = end;
    }
    return Double.NaN;
  }

  /** Returns where the step has to end within a part of it; NaN if it may go on. */
  private double searchPart(
      ModelEvents.Path path,
      int depth,
      double start,
      double[] atStart,
      double end,
      double[] atEnd) {
    double[] between = scratch[depth];
    return evaluate(path, 0.5 * (start + end), between)
        ? searchPart(path, depth, start, atStart, between, end, atEnd)
        : Double.NaN;
  }

  /** The same with the point in the middle of the part. */
  private double searchPart(
      ModelEvents.Path path,
      int depth,
      double start,
      double[] atStart,
      double[] between,
      double end,
      double[] atEnd) {
    double middle = 0.5 * (start + end);
    boolean decided = pieces.decide(atStart, between, atEnd);
    if (depth == 0) {
      noteSizes();
    }
    boolean finest = depth >= DEPTH || evaluations > allowed || !(middle > start && middle < end);
    if (!decided && (finest || openByNothing())) {
      int changed = changed(atStart, atEnd);
      if (changed < 0) {
        if (depth < DEPTH && evaluations > allowed) {
          noteUnsearched();
        }
        return Double.NaN;
      } else if (finest) {
        double place = narrowed(path, changed, start, atStart, end);
        return taken(changed, atStart, atEnd, place);
      }
    } else if (finest) {
      return Double.NaN;
    }
    if (decided && pieces.isEven()) {
      if (formulasShow(atStart, between, atEnd) || (start == begin && depth >= FORMULA_DEPTH)) {
        return Double.NaN;
      } else if (start > begin) {
        longestFirstStep = FIRST_STEP * (end - start);
        return start;
      }
    }
    double found = searchPart(path, depth + 1, start, atStart, middle, between);
    return Double.isNaN(found) ? searchPart(path, depth + 1, middle, between, end, atEnd) : found;
  }

  /** Notes that this step is accepted without being searched to its end. */
  private void noteUnsearched() {
    if (!gaveUp) {
      gaveUp = true;
      unsearched = unsearchedCount == 0 ? begin : unsearched;
      unsearchedCount++;
    }
  }

  /** Returns notes of what was found that the run cannot mend. */
  List<Note> notes() {
    List<Note> notes = new ArrayList<>(overlaps.notes());
    if (unsearchedCount > 0) {
      String text =
          "From here on "
              + unsearchedCount
              + (unsearchedCount == 1 ? " step was" : " steps were")
              + " accepted in which something may have happened unseen: a choice in the formulas"
              + " changes too often to be followed. Give the integrator a maxStep.";
      notes.add(new Note(MessageCode.STEP_NOT_SEARCHED, unsearched, true, text));
    }
    return notes;
  }

  private void noteSizes() {
    for (int choice = 0; choice < sizes.length; choice++) {
      double size = pieces.size(choice);
      sizes[choice] = Double.isFinite(size) ? Math.max(sizes[choice], size) : sizes[choice];
    }
  }

  /** Returns whether open choices go beyond their boundaries by no more than rounding counts. */
  private boolean openByNothing() {
    for (int k = 0; k < pieces.undecidedCount(); k++) {
      int choice = pieces.undecided(k);
      if (pieces.excursion(choice) > TOUCH * sizes[choice]) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns an open choice that differs at the ends of a part, of several the one that others may
   * follow from; −1 if there is none.
   */
  private int changed(double[] atStart, double[] atEnd) {
    int first = -1;
    for (int k = 0; k < pieces.undecidedCount(); k++) {
      int choice = pieces.undecided(k);
      if ((first < 0 || choice < first)
          && pieces.piece(choice, atStart) != pieces.piece(choice, atEnd)) {
        first = choice;
      }
    }
    return first;
  }

  /** Returns the time just behind the change of a choice in a part. */
  private double narrowed(
      ModelEvents.Path path, int choice, double start, double[] atStart, double end) {
    double piece = pieces.piece(choice, atStart);
    double before = start;
    double behind = end;
    double width = RESOLUTION * Math.ulp(end);
    while (behind - before > width) {
      double middle = 0.5 * (before + behind);
      if (!evaluate(path, middle, narrowing)) {
        break;
      }
      if (pieces.piece(choice, narrowing) == piece) {
        before = middle;
      } else {
        behind = middle;
      }
    }
    return clear(path, choice, behind, width);
  }

  /**
   * Returns a time just behind a change at which the argument of the choice is off its boundary by
   * more than rounding, so that equations that compute it in another order choose the same: at most
   * the end of the step, and {@value #FARTHEST} widths where the argument stays at the boundary.
   */
  private double clear(ModelEvents.Path path, int choice, double behind, double width) {
    double t = behind;
    for (double beyond = width; beyond <= FARTHEST * width; beyond *= 2) {
      if (t >= finish || !evaluate(path, t, narrowing)) {
        return Math.min(t, finish);
      } else if (pieces.distance(choice, narrowing) > CLEAR * sizes[choice]) {
        return t;
      }
      t = behind + beyond;
    }
    return Math.min(t, finish);
  }

  /** Returns the place of a change if it ends the step, else NaN. */
  private double taken(int choice, double[] atStart, double[] atEnd, double place) {
    if (!Double.isNaN(firstSeen[choice])) {
      return firstSeen[choice];
    } else if (shows(choice) && pieces.isSign(choice)) {
      firstSeen[choice] = place;
    } else if (counts(choice, atStart, atEnd)) {
      return place;
    }
    return Double.NaN;
  }

  /** Returns whether the ends of the step show that a choice changes in it. */
  private boolean shows(int choice) {
    return Math.abs(piecesTo[choice] - piecesFrom[choice]) == 1;
  }

  /**
   * Decides whether a change of a choice ends the step, and counts it if so. A choice that goes on
   * to a third piece does not hover about a boundary.
   */
  private boolean counts(int choice, double[] atStart, double[] atEnd) {
    double leaving = pieces.piece(choice, atStart);
    boolean back = leaving == left[choice] || pieces.piece(choice, atEnd) == left[choice];
    boolean close = back && sinceChange[choice] < CLOSE;
    double row = close ? closeChanges[choice] + 1 : 1;
    boolean taken = row <= (shows(choice) ? MOST_CLOSE : MOST_HIDDEN);
    if (!taken && !shows(choice)) {
      noteUnsearched();
    }
    if (looking) {
      sinceChange[choice] = 0;
      left[choice] = leaving;
      closeChanges[choice] = taken ? row : closeChanges[choice];
      changes[choice]++;
    }
    return taken;
  }

  /**
   * Looks, at the end of each row of steps, for a choice that jumps, has changed in them and has
   * stayed at its boundary all the time.
   */
  private void lookForSliding() {
    slidingSince = Double.NaN;
    rowBegan = stepsInRow == 0 ? begin : rowBegan;
    for (int choice = 0; choice < farthest.length; choice++) {
      if (pieces.jumps(choice)) {
        farthest[choice] = Math.max(farthest[choice], pieces.distance(choice, atFrom));
      }
    }
    if (++stepsInRow < ROW) {
      return;
    }
    for (int choice = 0; choice < farthest.length; choice++) {
      boolean hovers = farthest[choice] < HOVERING * sizes[choice];
      if (pieces.jumps(choice) && hovers && changes[choice] >= CHANGES) {
        slidingSince = rowBegan;
      }
    }
    stepsInRow = 0;
    Arrays.fill(farthest, 0);
    Arrays.fill(changes, 0);
  }

  /** Returns when the row of steps began that ended with the last at one jump, or NaN. */
  double slidingSince() {
    return slidingSince;
  }

  /**
   * Returns whether the formulas stay near their values at the ends of the step all over a part in
   * which they change evenly.
   */
  private boolean formulasShow(double[] atStart, double[] between, double[] atEnd) {
    if (!pieces.canBeNarrow()) {
      return true;
    }
    for (int r = 0; r < valueFrom.length; r++) {
      double least = Math.min(valueFrom[r], valueTo[r]);
      double most = Math.max(valueFrom[r], valueTo[r]);
      double expected =
          2 * (most - least) + 2 * Math.abs(valueFrom[r] - valueBefore[r]) + NOTHING * largest[r];
      double a = pieces.value(r, atStart);
      double m = pieces.value(r, between);
      double b = pieces.value(r, atEnd);
      double bow = MARGIN * Math.abs(a - 2 * m + b);
      double lowest = Math.min(a, Math.min(m, b)) - bow;
      double highest = Math.max(a, Math.max(m, b)) + bow;
      if (Math.max(highest - most, least - lowest) > expected) {
        if (!looking) {
          return false;
        }
        hidden = true;
        largest[r] = Math.max(largest[r], Math.max(-lowest, highest));
      }
    }
    return true;
  }

  /**
   * Moves a state along its derivative across the next change of a choice that matters, if that is
   * within {@value #ROUNDINGS} roundings of t.
   *
   * @param behind overwritten
   * @return whether there is such a change
   */
  boolean moveAcross(double t, double[] y, double[] yDot, double[] behind) {
    quantities.evaluate(t, y, here);
    pieces.at(here, atFrom);
    int crossed = -1;
    for (double roundings = 1; roundings <= ROUNDINGS; roundings *= 2) {
      double ahead = roundings * Math.ulp(t);
      for (int l = 0; l < y.length; l++) {
        behind[l] = y[l] + ahead * yDot[l];
      }
      quantities.evaluate(t, behind, here);
      pieces.at(here, atTo);
      if (crossed < 0 && !pieces.decide(atFrom, atTo, atTo)) {
        crossed = changed(atFrom, atTo);
      }
      if (crossed >= 0 && pieces.distance(crossed, atTo) > CLEAR * sizes[crossed]) {
        begun = false;
        boxed = false;
        return true;
      }
    }
    return false;
  }

  /** Returns the length of {@link #save}. */
  int stateLength() {
    return Arrays.stream(parts()).mapToInt(part -> part.length).sum() + 9;
  }

  /** Writes what later searches depend on. */
  void save(double[] state) {
    int at = 0;
    for (double[] part : parts()) {
      System.arraycopy(part, 0, state, at, part.length);
      at += part.length;
    }
    state[at] = begun ? 1 : 0;
    state[at + 1] = longestFirstStep;
    state[at + 2] = boxed ? 1 : 0;
    state[at + 3] = stepsInRow;
    state[at + 4] = rowBegan;
    state[at + 5] = unsearched;
    state[at + 6] = unsearchedCount;
    state[at + 7] = pause;
    state[at + 8] = pauseLeft;
  }

  /** Restores what {@link #save} has written. */
  void restore(double[] state) {
    int at = 0;
    for (double[] part : parts()) {
      System.arraycopy(state, at, part, 0, part.length);
      at += part.length;
    }
    begun = state[at] == 1;
    longestFirstStep = state[at + 1];
    boxed = state[at + 2] == 1;
    stepsInRow = state[at + 3];
    rowBegan = state[at + 4];
    unsearched = state[at + 5];
    unsearchedCount = (long) state[at + 6];
    pause = state[at + 7];
    pauseLeft = state[at + 8];
  }

  private double[][] parts() {
    double[][] seen = overlaps.carried();
    return new double[][] {
      valueBefore,
      largest,
      sizes,
      sinceChange,
      closeChanges,
      left,
      farthest,
      changes,
      boxLow,
      boxHigh,
      seen[0],
      seen[1],
      seen[2]
    };
  }
}
