package org.mechservice.solver.mechanism.force;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.ForceRow;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * A force between two bodies that is a law of the catalogue with its numbers. The load acts on body
 * 2 at the origin of frame 2, and its opposite on the same line on body 1.
 *
 * @param name name in the model file
 * @param law one with a {@link PairLaw#row}
 * @param frame1 on body 1
 * @param frame2 on body 2
 * @param numbers the coefficients of the law, SI
 * @param origin position in the model file
 */
public record LawForce(
    String name,
    PairLaw law,
    BodyFrame frame1,
    BodyFrame frame2,
    List<Expression> numbers,
    Origin origin)
    implements ForceElement {
  /**
   * @throws IllegalArgumentException if the law is no element, or takes another number of numbers
   */
  public LawForce {
    numbers = List.copyOf(numbers);
    if (law.row().isEmpty() || law.coefficientCount() != numbers.size()) {
      throw new IllegalArgumentException(
          "force " + name + ": " + law + " does not take " + numbers.size() + " numbers");
    }
  }

  private ForceRow row() {
    return law.row().orElseThrow();
  }

  @Override
  public List<Coefficient> coefficients() {
    List<Coefficient> all = new ArrayList<>();
    for (int i = 0; i < numbers.size(); i++) {
      ForceRow.Attribute number = row().attributes().get(i);
      all.add(new Coefficient(number.name(), numbers.get(i), number.condition()));
    }
    return all;
  }

  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return row().outputs();
  }

  @Override
  public String kind() {
    return row().element();
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.lawForce(this);
  }

  @Override
  public List<Integer> bodies() {
    return List.of(frame1.body(), frame2.body());
  }
}
