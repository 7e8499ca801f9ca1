package org.mechservice.sim.emit.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.IndexExpression;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.ParameterSlots;
import org.mechservice.sim.emit.method.Statement;
import org.mechservice.sim.emit.method.ValueLocation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * The method of one section rewritten over numbered operands: the elements of arrays that it reads
 * and writes, the results with which it ends the program, and its constants.
 *
 * <p>All sections use one common graph, in which equal structures are the same nodes. Two sections
 * with the same operations in the same order therefore have equal bodies.
 */
final class KernelBody {
  /** Locations of the operands and constants of a section. */
  interface Addresses {
    /** Returns the index of an operand in its array. */
    IndexExpression index(int operand);

    /** Returns the location of a constant. */
    ValueLocation constant(int constant);
  }

  /** Addresses for the comparison of sections: every operand and every constant is numbered. */
  private static final Addresses SHAPE =
      new Addresses() {
        @Override
        public IndexExpression index(int operand) {
          return new IndexExpression(operand, 0);
        }

        @Override
        public ValueLocation constant(int constant) {
          return new ValueLocation.Element(ConstantTable.NAME, new IndexExpression(constant, 0));
        }
      };

  private final MethodPlan section;
  private final MethodSignature head;
  private final Expressions common;
  private final int numbersAt;
  private final Addresses addresses;
  private final List<Integer> operands = new ArrayList<>();
  private final List<Double> constants = new ArrayList<>();
  private final List<Statement> statements = new ArrayList<>();
  private final Map<Scalar, ValueLocation> places = new HashMap<>();
  private final Map<Scalar, Scalar> images = new HashMap<>();
  private int leaves;

  private KernelBody(
      MethodPlan section,
      MethodSignature head,
      Expressions common,
      int numbersAt,
      Addresses addresses) {
    this.section = section;
    this.numbersAt = numbersAt;
    this.head = head;
    this.common = common;
    this.addresses = addresses;
  }

  /**
   * Returns the common part of the sections of a kernel.
   *
   * @param section the method of one section
   * @param head the method that runs the program
   * @param common the graph that all sections share
   * @param numbersAt where the numbers of the program's graph begin in the table of constants
   */
  static KernelBody of(
      MethodPlan section, MethodSignature head, Expressions common, int numbersAt) {
    KernelBody body = new KernelBody(section, head, common, numbersAt, SHAPE);
    body.write();
    return body;
  }

  /** Returns the method shared by this section and equal ones, with a remark. */
  MethodPlan method(Addresses shared, int parameters, String remark) {
    KernelBody body = new KernelBody(section, head, common, numbersAt, shared);
    body.write();
    List<Statement> remarked = new ArrayList<>();
    remarked.add(new Statement.Comment(title() + remark));
    remarked.addAll(body.statements);
    Map<Scalar, Scalar> originals = new HashMap<>();
    body.images.forEach((original, image) -> originals.put(image, original));
    return new MethodPlan(remarked, body.places, originals, parameters);
  }

  private String title() {
    return section.statements().get(0) instanceof Statement.Comment comment ? comment.text() : "";
  }

  /** Returns statements and places, equal to those of a section of the same structure. */
  MethodPlan shape() {
    return new MethodPlan(statements, places);
  }

  /** Returns the indices of the operands, in order. */
  List<Integer> operands() {
    return operands;
  }

  /** Returns the constants, in order. */
  List<Double> constants() {
    return constants;
  }

  private void write() {
    for (Statement statement : LoadOrder.byFirstUse(section)) {
      if (statement instanceof Statement.Load load) {
        Scalar leaf = leaf(outside(load.from()));
        statements.add(new Statement.Load(leaf, placeOf(leaf), load.again()));
        local(load.value(), leaf);
      } else if (statement instanceof Statement.Define define) {
        Scalar image = operation(define.value());
        statements.add(new Statement.Define(image));
        local(define.value(), image);
      } else if (statement instanceof Statement.Store store) {
        put(
            new ValueLocation.Element(ParameterSlots.WORKSPACE, operand(store.slot())),
            store.value());
      } else if (statement instanceof Statement.PutOut output) {
        put(new ValueLocation.Element(head.output(), operand(output.index())), output.value());
      } else if (statement instanceof Statement.CopyInputs copy) {
        copy(copy);
      } else if (statement instanceof Statement.Check check) {
        check(check);
      }
    }
  }

  private ValueLocation placeOf(Scalar leaf) {
    return places.getOrDefault(leaf, new ValueLocation.Local(leaf));
  }

  private void local(Scalar value, Scalar image) {
    images.put(value, image);
    places.put(image, new ValueLocation.Local(image));
  }

  private void put(ValueLocation.Element to, Scalar value) {
    statements.add(new Statement.Put(to, value(value)));
  }

  private void copy(Statement.CopyInputs copy) {
    for (int i = 0; i < copy.count(); i++) {
      Scalar leaf = leaf(outside(new ValueLocation.Input(copy.input() + i)));
      ValueLocation.Element to =
          new ValueLocation.Element(head.output(), operand(copy.index() + i));
      statements.add(new Statement.Put(to, leaf));
    }
  }

  private void check(Statement.Check check) {
    Scalar pivot = value(check.pivot());
    Scalar bound = value(check.bound());
    String meaning = addresses == SHAPE ? "" : check.meaning();
    statements.add(new Statement.Check(pivot, bound, operand(check.result().offset()), meaning));
  }

  private IndexExpression operand(int number) {
    operands.add(number);
    return addresses.index(operands.size() - 1);
  }

  /** Returns a location outside the method by the parameter through which it is accessed. */
  private ValueLocation outside(ValueLocation place) {
    if (place instanceof ValueLocation.Slot slot) {
      return new ValueLocation.Element(ParameterSlots.WORKSPACE, operand(slot.index()));
    }
    ValueLocation.Input input = (ValueLocation.Input) place;
    MethodSignature.Argument argument = head.argumentOf(input.index());
    return argument.isArray()
        ? new ValueLocation.Element(argument.name(), operand(input.index() - argument.first()))
        : input;
  }

  /**
   * Returns the leaf of a location; leaves are numbered in the order of first use, so equal
   * structures have the same leaves.
   */
  private Scalar leaf(ValueLocation place) {
    Scalar leaf = common.input(leaves);
    leaves++;
    places.put(leaf, place);
    return leaf;
  }

  private Scalar value(Scalar node) {
    Scalar image = images.get(node);
    if (image != null) {
      return image;
    }
    ValueLocation place = section.places().get(node);
    return place == null ? operation(node) : leaf(outside(place));
  }

  private Scalar operation(Scalar node) {
    if (node.isNumber() && !node.isConstant()) {
      return leaf(new ValueLocation.Element(ConstantTable.NAME, operand(numbersAt + node.index())));
    } else if (node.isNumber()) {
      constants.add(node.value());
      return leaf(addresses.constant(constants.size() - 1));
    } else if (node.operation() == ScalarOperation.INPUT) {
      return leaf(outside(new ValueLocation.Input(node.index())));
    }
    List<Scalar> images = new ArrayList<>();
    for (Scalar operand : node.operands()) {
      images.add(value(operand));
    }
    return common.alike(node, images);
  }
}
