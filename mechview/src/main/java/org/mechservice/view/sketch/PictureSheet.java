package org.mechservice.view.sketch;

import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.mechservice.solver.api.JointType;
import org.mechservice.view.drawing.Canvas;
import org.mechservice.view.drawing.Ink;
import org.mechservice.view.drawing.Label;
import org.mechservice.view.drawing.Label.Anchoring;
import org.mechservice.view.drawing.Pen;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneJoint;
import org.mechservice.view.scene.SceneVerdict;

/**
 * The sheet of a drawing: all that is written around the mechanism. Above it are its name and the
 * direction of gravity, below it the world's axes, a scale, a legend of symbols and colours, and
 * what {@code mech check} says in words.
 */
final class PictureSheet {
  private static final double WIDTH = SceneLayout.WIDTH;
  private static final double BELOW = 66;
  private static final double MARGIN = 16;
  private static final double FONT = 12;
  private static final double LINE = 17;

  private final SceneDescription scene;
  private final SceneLayout layout;
  private final Canvas canvas;
  private final ForceSymbols forces;

  /**
   * @param size of symbols, 1 being the usual one
   */
  PictureSheet(SceneDescription scene, SceneLayout layout, double size) {
    this.scene = scene;
    this.layout = layout;
    double legend = (LINE + 4) * legendRows().size() + (colourWords().isEmpty() ? 0 : LINE);
    canvas =
        new Canvas(
            WIDTH,
            below() + legend + captions(0).size() * LINE + (isCrowded() ? LINE : 0),
            scene.name(),
            description());
    forces = new ForceSymbols(canvas, size);
  }

  /** Returns what everything is drawn on. */
  Canvas canvas() {
    return canvas;
  }

  /** Returns the area in which names may be. */
  NamePlaces names() {
    return new NamePlaces(
        new Rectangle2D.Double(
            4, SceneLayout.TOP - 40, WIDTH - 8, layout.fieldHeight() + 40 + BELOW - 26));
  }

  private double below() {
    return SceneLayout.TOP + layout.fieldHeight() + BELOW;
  }

  /** Returns whether names may find no place. */
  private boolean isCrowded() {
    return scene.bodies().size() + scene.joints().size() > 20;
  }

  /** Writes what is above the mechanism. */
  void writeAbove() {
    canvas.write(
        new Label(
                MARGIN,
                MARGIN + 12,
                Label.shortened(scene.name(), FONT + 2, 500),
                FONT + 2,
                Anchoring.START,
                Ink.TEXT)
            .inBold());
    gravity();
  }

  /** Keeps names away from what is written beside the mechanism. */
  void keepFree(NamePlaces names) {
    names.keepFree(new Rectangle2D.Double(0, below() - 72, MARGIN + 72, 72));
    names.keepFree(new Rectangle2D.Double(WIDTH - 170, below() - 44, 170, 44));
    names.keepFree(new Rectangle2D.Double(WIDTH - 190, 0, 190, MARGIN + 36));
  }

  /**
   * Writes what is below the mechanism.
   *
   * @param unwritten number of names that the drawing lacks
   */
  void writeBelow(int unwritten) {
    axes(new Place(MARGIN + 30, below() - 34));
    scaleBar(below() - 22);
    double y = legend(below() + 8);
    for (String line : captions(unwritten)) {
      canvas.write(new Label(MARGIN, y, line, FONT, Anchoring.START, Ink.TEXT));
      y += LINE;
    }
  }

  private void gravity() {
    double g = scene.gravity().norm();
    String text = g == 0 ? "no gravity" : "g = " + String.format(Locale.ROOT, "%.4g", g) + " m/s²";
    double right = WIDTH - MARGIN - 14;
    canvas.write(new Label(right - 14, MARGIN + 14, text, FONT, Anchoring.END, Ink.MUTED));
    if (g > 0) {
      Place along = layout.direction(scene.gravity().times(1 / g));
      Place middle = new Place(right, MARGIN + 16);
      canvas.part(
          "direction of gravity",
          () -> {
            if (along.length() < 0.2) {
              forces.sphere(middle, 6, Ink.MUTED);
              forces.dot(middle, Ink.MUTED);
            } else {
              forces.arrow(
                  middle.minus(along.times(16)), middle.plus(along.times(16)), Ink.MUTED, 2);
            }
          });
    }
  }

  /** Draws the directions of the world's axes with their letters. */
  private void axes(Place at) {
    Point3[] axes = {new Point3(1, 0, 0), new Point3(0, 1, 0), new Point3(0, 0, 1)};
    Ink[] inks = {Ink.CURVE_4, Ink.CURVE_2, Ink.CURVE_0};
    String[] letters = {"x", "y", "z"};
    canvas.part(
        "world axes",
        () -> {
          for (int i = 0; i < 3; i++) {
            Place shown = layout.direction(axes[i]);
            if (shown.length() > 0.1) {
              Place tip = at.plus(shown.times(20));
              forces.arrow(at, tip, inks[i], 1.4);
              Place letter = tip.plus(shown.unit().times(8));
              canvas.write(
                  new Label(
                      letter.x(), letter.y() + 4, letters[i], FONT, Anchoring.MIDDLE, inks[i]));
            }
          }
        });
  }

  private void scaleBar(double y) {
    double longest = 130 / layout.scale();
    double power = Math.pow(10, Math.floor(Math.log10(longest)));
    double length = power;
    for (double factor : new double[] {2, 5}) {
      length = factor * power <= longest ? factor * power : length;
    }
    double right = WIDTH - MARGIN - 14;
    double left = right - length * layout.scale();
    Pen pen = new Pen(Ink.MUTED, 1.4);
    canvas.draw(new Line2D.Double(left, y, right, y), pen);
    canvas.draw(new Line2D.Double(left, y - 4, left, y + 4), pen);
    canvas.draw(new Line2D.Double(right, y - 4, right, y + 4), pen);
    canvas.write(
        new Label((left + right) / 2, y - 8, length(length), FONT, Anchoring.MIDDLE, Ink.MUTED));
  }

  private static String length(double metres) {
    String[] units = {"nm", "µm", "mm", "m", "km"};
    int unit =
        Math.max(0, Math.min(4, 3 + Math.floorDiv((int) Math.floor(Math.log10(metres) + 1e-9), 3)));
    if (unit == 3 || (metres >= 0.1 && metres < 1)) {
      return String.format(Locale.ROOT, "%.4g", metres).replaceFirst("\\.?0+$", "") + " m";
    }
    double shown = metres * Math.pow(1000, 3 - unit);
    return Math.round(shown) + " " + units[unit];
  }

  /** Returns the types of joints in words, in lines that fit the picture. */
  private List<List<JointType>> legendRows() {
    Set<JointType> types = EnumSet.noneOf(JointType.class);
    scene.joints().forEach(joint -> types.add(joint.type()));
    List<List<JointType>> rows = new ArrayList<>();
    double used = WIDTH;
    for (JointType type : types) {
      double needed = entryWidth(JointSymbols.word(type));
      if (used + needed > WIDTH - 2 * MARGIN) {
        rows.add(new ArrayList<>());
        used = 0;
      }
      rows.get(rows.size() - 1).add(type);
      used += needed;
    }
    return rows;
  }

  private static double entryWidth(String word) {
    return 34 + Label.width(word, FONT) + 18;
  }

  /** Draws the symbols used with their names; returns where the next line may be, px. */
  private double legend(double top) {
    JointSymbols samples = new JointSymbols(canvas, 0.8);
    double y = top;
    for (List<JointType> row : legendRows()) {
      double x = MARGIN;
      for (JointType type : row) {
        samples.draw(type, new Place(x + 12, y - 4), usualAxis(type), new Place(0, 1), Ink.TEXT);
        String word = JointSymbols.word(type);
        canvas.write(new Label(x + 30, y, word, FONT, Anchoring.START, Ink.MUTED));
        x += entryWidth(word);
      }
      y += LINE + 4;
    }
    return colours(y);
  }

  /** Returns the direction for a sample of a symbol: along, unless joints point at the viewer. */
  private Place usualAxis(JointType type) {
    boolean seen =
        scene.joints().stream()
            .filter(joint -> joint.type() == type)
            .allMatch(joint -> layout.direction(Projection.axis(scene, joint)).length() > 0.35);
    return seen ? new Place(1, 0) : new Place(0, 0);
  }

  /** Writes what the colours mean, each word in its colour. */
  private double colours(double y) {
    Map<String, Ink> words = colourWords();
    double x = MARGIN;
    for (Map.Entry<String, Ink> word : words.entrySet()) {
      Label label = new Label(x, y, word.getKey(), FONT, Anchoring.START, word.getValue());
      canvas.write(label);
      x += label.box().getWidth() + 18;
    }
    return words.isEmpty() ? y : y + LINE;
  }

  private Map<String, Ink> colourWords() {
    Map<String, Ink> words = new LinkedHashMap<>();
    if (scene.joints().stream().anyMatch(SceneJoint::cut)) {
      words.put("cut joint", MechanismPicture.CUT);
    }
    if (scene.joints().stream().anyMatch(joint -> joint.driven() && !joint.cut())) {
      words.put("driven joint", MechanismPicture.DRIVEN);
    }
    if (!scene.constraints().isEmpty()) {
      words.put("constraint", MechanismPicture.CONSTRAINT);
    }
    if (!scene.forces().isEmpty()) {
      words.put("force", MechanismPicture.FORCE);
    }
    return words;
  }

  /** Returns what check says, in lines that fit. */
  private List<String> captions(int unwritten) {
    SceneVerdict verdict = scene.verdict();
    List<String> lines = new ArrayList<>();
    long cut = scene.joints().stream().filter(SceneJoint::cut).count();
    lines.add(
        count(scene.bodies().size(), "body", "bodies")
            + ", "
            + count(scene.joints().size(), "joint", "joints")
            + (cut == 0 ? "" : " (" + cut + " cut)")
            + (scene.constraints().isEmpty()
                ? ""
                : ", " + count(scene.constraints().size(), "constraint", "constraints"))
            + (scene.forces().isEmpty()
                ? ""
                : ", " + count(scene.forces().size(), "force", "forces"))
            + ": "
            + count(verdict.degreesOfFreedom(), "degree", "degrees")
            + " of freedom");
    if (verdict.equations() > 0) {
      lines.add(
          count(verdict.equations(), "equation closes", "equations close")
              + " the loops; "
              + (!verdict.assembled()
                  ? "THE LOOPS CANNOT BE CLOSED, the drawing has them open"
                  : verdict.redundant() == 0
                      ? "none is redundant"
                      : count(verdict.redundant(), "is redundant", "are redundant")));
    }
    if (!verdict.warnings().isEmpty()) {
      lines.add(count(verdict.warnings().size(), "warning", "warnings") + " of mech check");
    }
    if (unwritten > 0) {
      lines.add(count(unwritten, "name has", "names have") + " no place here");
    }
    return lines;
  }

  private static String count(int number, String one, String many) {
    return number + " " + (number == 1 ? one : many);
  }

  private String description() {
    String bodies =
        String.join(", ", scene.bodies().stream().limit(50).map(SceneBody::name).toList());
    return "The mechanism at the start of its run. "
        + String.join(". ", captions(0))
        + ". Bodies: "
        + bodies
        + (scene.bodies().size() > 50 ? " and more." : ".");
  }
}
