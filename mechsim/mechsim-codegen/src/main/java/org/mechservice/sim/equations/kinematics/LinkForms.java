package org.mechservice.sim.equations.kinematics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.DoubleFunction;
import org.mechservice.solver.links.AxesChange;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.step.LinkNumbers;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;

/**
 * In which form the equations of each link are written. Zeros and ones among a link's numbers save
 * operations, and make its equations different from those of a link with others: in a large tree
 * each link then needs code of its own, where one method could serve all links of a kind
 * (docs/theory/formulations.md#methods). So in a large mechanism the equations of a link keep its
 * zeros and ones as operands, unless many links have them at the same places. The values have the
 * same bits in both forms.
 */
final class LinkForms {
  /** Links of a mechanism up to which each is written with its own zeros and ones. */
  private static final int FEW_LINKS = 100;

  /** Links with zeros and ones at the same places that are written with them. */
  private static final int MANY_ALIKE = 12;

  private final Expressions expressions;
  private final Set<Link> alone = Collections.newSetFromMap(new IdentityHashMap<>());

  /**
   * @param links all links of the mechanism
   */
  LinkForms(Expressions expressions, List<Link> links) {
    this.expressions = expressions;
    if (links.size() > FEW_LINKS) {
      Map<List<Object>, List<Link>> alike = new HashMap<>();
      for (Link link : links) {
        alike.computeIfAbsent(pattern(link), key -> new ArrayList<>()).add(link);
      }
      alike.values().stream().filter(of -> of.size() < MANY_ALIKE).forEach(alone::addAll);
    }
  }

  /** Returns the kind of a link, and at which places it has zeros and ones. */
  private static List<Object> pattern(Link link) {
    List<Object> pattern = new ArrayList<>();
    pattern.add(link.kind());
    pattern.add(link.inverse());
    pattern.add(link.axes().turn().map(AxesChange.Turn::axis));
    pattern.add(link.armature() == 0);
    Arrays.stream(LinkNumbers.values(link))
        .forEach(number -> pattern.add(isZeroOrOne(number) ? number + 0.0 : Double.NaN));
    return pattern;
  }

  private static boolean isZeroOrOne(double number) {
    return number == 0 || Math.abs(number) == 1;
  }

  /** Returns how the numbers of a link become scalars. */
  DoubleFunction<Scalar> numbers(Link link) {
    if (!alone.contains(link)) {
      return expressions::constant;
    }
    // the links within a joint of several freedoms have no mass, and all their zeros are alike
    return link.mass() == 0
        ? number -> number == 0 ? expressions.zero() : expressions.number(number)
        : expressions::number;
  }
}
