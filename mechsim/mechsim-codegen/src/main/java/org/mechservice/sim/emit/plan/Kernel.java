package org.mechservice.sim.emit.plan;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.IndexExpression;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.sim.emit.method.ValueLocation;

/**
 * A method that several sections share, and the arguments of each section.
 *
 * <p>One integer argument addresses all operands whose distances are equal in all sections;
 * operands that are the same in all sections are written out. Constants in which the sections
 * differ are in one row of the {@link ConstantTable} per section; its start is a further integer
 * argument.
 */
final class Kernel implements KernelBody.Addresses {
  private final List<KernelBody> sections;
  private final List<IndexExpression> indices = new ArrayList<>();
  private final List<ValueLocation> constants = new ArrayList<>();

  /** Integer arguments; those of section i are the i-th elements. */
  private final List<int[]> parameters = new ArrayList<>();

  /**
   * @param sections sections that share the method, of the same shape, in order
   */
  Kernel(List<KernelBody> sections, ConstantTable table) {
    this.sections = sections;
    shareIndices();
    shareConstants(table);
  }

  private void shareIndices() {
    int operands = sections.get(0).operands().size();
    List<int[]> columns = new ArrayList<>();
    List<Integer> bases = new ArrayList<>();
    for (int k = 0; k < operands; k++) {
      int[] column = column(k);
      columns.add(column);
      bases.add(isUniform(column) ? IndexExpression.NONE : baseOf(column));
    }
    for (int k = 0; k < operands; k++) {
      int base = bases.get(k);
      int from = base == IndexExpression.NONE ? 0 : parameters.get(base)[0];
      indices.add(new IndexExpression(base, columns.get(k)[0] - from));
    }
  }

  private int[] column(int operand) {
    int[] column = new int[sections.size()];
    for (int i = 0; i < column.length; i++) {
      column[i] = sections.get(i).operands().get(operand);
    }
    return column;
  }

  private static boolean isUniform(int[] column) {
    for (int value : column) {
      if (value != column[0]) {
        return false;
      }
    }
    return true;
  }

  /** Returns the integer argument from which a column has a constant distance. */
  private int baseOf(int[] column) {
    for (int p = 0; p < parameters.size(); p++) {
      int[] base = parameters.get(p);
      int distance = column[0] - base[0];
      boolean along = true;
      for (int i = 1; i < column.length && along; i++) {
        along = column[i] - base[i] == distance;
      }
      if (along) {
        if (distance < 0) {
          parameters.set(p, column);
        }
        return p;
      }
    }
    parameters.add(column);
    return parameters.size() - 1;
  }

  private void shareConstants(ConstantTable table) {
    int parameter = parameters.size();
    List<List<Double>> kept = new ArrayList<>();
    for (int k = 0; k < sections.get(0).constants().size(); k++) {
      List<Double> column = new ArrayList<>();
      for (KernelBody section : sections) {
        column.add(section.constants().get(k));
      }
      if (column.stream().distinct().count() == 1) {
        constants.add(new ValueLocation.Constant(column.get(0)));
      } else {
        int known = kept.indexOf(column);
        if (known < 0) {
          known = kept.size();
          kept.add(column);
        }
        constants.add(
            new ValueLocation.Element(ConstantTable.NAME, new IndexExpression(parameter, known)));
      }
    }
    if (!kept.isEmpty()) {
      int[] rows = new int[sections.size()];
      for (int i = 0; i < rows.length; i++) {
        int section = i;
        rows[i] = table.add(kept.stream().map(column -> column.get(section)).toList());
      }
      parameters.add(rows);
    }
  }

  @Override
  public IndexExpression index(int operand) {
    return indices.get(operand);
  }

  @Override
  public ValueLocation constant(int constant) {
    return constants.get(constant);
  }

  /** Returns the method. */
  MethodPlan method() {
    int others = sections.size() - 1;
    String remark =
        "\nand " + others + (others == 1 ? " other" : " others") + " alike; names are of the first";
    return sections.get(0).method(this, parameters.size(), remark);
  }

  /** Returns the arguments of a section. */
  List<Integer> numbersOf(int section) {
    return parameters.stream().map(parameter -> parameter[section]).toList();
  }
}
