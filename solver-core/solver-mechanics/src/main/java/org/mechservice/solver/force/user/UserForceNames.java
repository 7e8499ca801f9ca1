package org.mechservice.solver.force.user;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.applied.TreeCoordinate;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.NamedPoint;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.WellFormedText;

/**
 * Resolves the names that a user force declares in its model, and records the declared quantities.
 */
final class UserForceNames implements ForceDeclaration {
  /** Beginning of the message about an unusable force class; the force's name follows. */
  static final String REFUSED = MessageCode.FORCE_CLASS_UNUSABLE + " force \"";

  private final UserForceElement element;
  private final TreeGeometry tree;
  private final Mechanism mechanism;

  /** Declared points, in the order of the indices returned. */
  final List<BodyPoint> bodyPoints = new ArrayList<>();

  final List<DeclaredPoint> points = new ArrayList<>();
  final List<TreeCoordinate> coordinates = new ArrayList<>();
  final List<Integer> parameters = new ArrayList<>();
  final List<Variable> values = new ArrayList<>();

  UserForceNames(UserForceElement element, TreeGeometry tree) {
    this.element = element;
    this.tree = tree;
    mechanism = tree.mechanism();
  }

  @Override
  public int point(String body, String point, Reads... reads) {
    for (NamedPoint named : element.points()) {
      if (named.body().equals(body) && named.name().equals(point)) {
        return add(named.point(), reads);
      }
    }
    throw unknown("point", body + "." + point);
  }

  @Override
  public int pointAt(String body, double x, double y, double z, Reads... reads) {
    Vector3 place = new Vector3(x, y, z);
    if (mechanism.root().name().equals(body)) {
      return add(new BodyPoint(BodyPoint.ROOT, place), reads);
    }
    for (int b = 0; b < mechanism.bodies().size(); b++) {
      if (mechanism.bodies().get(b).name().equals(body)) {
        return add(new BodyPoint(b, place), reads);
      }
    }
    throw unknown("body", body);
  }

  private int add(BodyPoint point, Reads[] reads) {
    Set<Reads> wanted = EnumSet.noneOf(Reads.class);
    wanted.addAll(List.of(reads));
    bodyPoints.add(point);
    points.add(new DeclaredPoint(tree, point, wanted));
    return points.size() - 1;
  }

  @Override
  public int coordinate(String joint, int component) {
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (mechanism.joints().get(j).name().equals(joint)) {
        coordinates.add(TreeCoordinate.ofVelocity(tree, new JointCoordinate(j, component)));
        return coordinates.size() - 1;
      }
    }
    throw unknown("joint of the tree", joint);
  }

  @Override
  public int parameter(String name) {
    for (int p = 0; p < mechanism.parameters().size(); p++) {
      if (mechanism.parameters().get(p).name().equals(name)) {
        parameters.add(p);
        return parameters.size() - 1;
      }
    }
    throw unknown("parameter", name);
  }

  @Override
  public int value(String name, String unit) {
    values.add(new Variable(WellFormedText.of(name), WellFormedText.of(unit)));
    return values.size() - 1;
  }

  private IllegalArgumentException unknown(String kind, String name) {
    return new IllegalArgumentException(
        REFUSED
            + element.name()
            + "\" ("
            + element.className()
            + ") asks for the "
            + kind
            + " \""
            + name
            + "\", which the model does not have");
  }
}
