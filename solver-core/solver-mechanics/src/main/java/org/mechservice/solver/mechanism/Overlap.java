package org.mechservice.solver.mechanism;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.RelativeMotion;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.spatial.Rotation;

/**
 * How far two shapes in contact are inside each other, and how far the law of their contact means
 * anything: until the centre of a sphere is inside or behind the other shape, and the like.
 *
 * @param contact name of the contact
 * @param depth penetration, m
 * @param most largest penetration that means anything, m; there is none where this is zero
 */
public record Overlap(String contact, Expression depth, Expression most) {
  /** Returns the overlaps of a mechanism's contacts, in file order. */
  static List<Overlap> of(Mechanism mechanism) {
    List<Overlap> all = new ArrayList<>();
    for (ForceElement force : mechanism.forces()) {
      if (force instanceof PairForce pair && pair.mostDepth() != Expression.ZERO) {
        all.add(new Overlap(pair.name(), pair.depth(), pair.mostDepth()));
      } else if (force instanceof Contact contact && contact.radius() != Expression.ZERO) {
        all.add(of(contact));
      }
    }
    return all;
  }

  /** A sphere's centre is behind the surface where it lies below it, whatever the slope. */
  private static Overlap of(Contact contact) {
    BodyPoint center = contact.center();
    BodyFrame ball = new BodyFrame(center.body(), center.position(), Rotation.IDENTITY);
    Map<Expression, Expression> station =
        Map.of(new Argument(), new RelativeMotion(contact.surface(), ball, 0));
    Expression height = WatchedFormulas.replaced(contact.height(), station);
    Expression z = new RelativeMotion(contact.surface(), ball, 2);
    Expression depth = new Sum(new Sum(contact.radius(), height), new Negation(z));
    return new Overlap(contact.name(), depth, contact.radius());
  }
}
