package org.mechservice.sim.model;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.mechservice.sim.emit.CompactClass;
import org.mechservice.sim.emit.GeneratedClass;
import org.mechservice.sim.emit.ModelClass;
import org.mechservice.solver.api.result.ColumnGroup;

/**
 * A model specialised to its scene: the planned programs of its class, ready to be written as Java
 * source or as a class file. Immutable.
 */
public final class GeneratedModel {
  private final GeneratedClass written;
  private final Optional<CompactClass> columns;
  private final Optional<GeneratedClass> values;
  private final GeneratedFacts facts;

  /**
   * @param written class of the equations
   * @param columns class that adds columns computed from data
   * @param values class of triggers and assignments of events and of outputs
   * @param modelName the model's name in its file
   * @param formulation formulation of its equations
   * @param formulationReason reason for the formulation
   * @param operations additions, multiplications and divisions of one evaluation of the derivative
   * @param leftOut parts that the scene does not need
   * @param fromData parts computed from data in addition to the code
   */
  GeneratedModel(
      GeneratedClass written,
      Optional<CompactClass> columns,
      Optional<GeneratedClass> values,
      String modelName,
      String formulation,
      String formulationReason,
      int operations,
      List<Omission> leftOut,
      List<Omission> fromData) {
    this.written = written;
    this.columns = columns;
    this.values = values;
    this.facts =
        new GeneratedFacts(
            columns.isPresent() ? name(columns.get()) : name(written),
            name(written),
            modelName,
            formulation,
            formulationReason,
            operations,
            written.code(),
            dataColumns(),
            leftOut,
            fromData);
  }

  private Set<ColumnGroup> dataColumns() {
    Set<ColumnGroup> groups = EnumSet.noneOf(ColumnGroup.class);
    parts()
        .filter(part -> part instanceof CompactClass data && !data.columns().isEmpty())
        .forEach(part -> groups.addAll(ColumnGroup.of(((CompactClass) part).columns())));
    return groups;
  }

  /** Returns the facts that are kept after its classes are written. */
  public GeneratedFacts facts() {
    return facts;
  }

  /** Returns the number of values in its plans; each takes about a hundred bytes of memory. */
  public long plannedValues() {
    return parts().mapToLong(GeneratedClass::plannedValues).sum();
  }

  /** Returns the fully qualified name of the class to be instantiated. */
  public String className() {
    return facts.className();
  }

  /** Returns the fully qualified name of the class of the equations. */
  public String sourceName() {
    return facts.sourceName();
  }

  private static String name(GeneratedClass written) {
    return ModelClass.PACKAGE + "." + written.simpleName();
  }

  /** Returns the formatted source of the class of the equations. */
  public String source() {
    return written.source();
  }

  /**
   * Returns the sources of all its classes, {@link #source} first; together they compile to the
   * model.
   */
  public List<SourceFile> sources() {
    return parts().map(part -> new SourceFile(name(part), part.source())).toList();
  }

  private Stream<GeneratedClass> parts() {
    return Stream.of(Stream.of(written), columns.stream(), values.stream()).flatMap(part -> part);
  }

  /**
   * Returns the class files by binary name; the class of the equations gives the same bits as
   * {@link #source}.
   */
  public SortedMap<String, byte[]> classFiles() {
    SortedMap<String, byte[]> files = new TreeMap<>();
    files.put(sourceName(), written.classFile());
    if (columns.isPresent()) {
      files.put(name(columns.get()), columns.get().classFile());
    }
    if (values.isPresent()) {
      files.put(name(values.get()), values.get().classFile());
    }
    return files;
  }

  /** Returns the formulation of its equations. */
  public String formulation() {
    return facts.formulation();
  }

  /** Returns the reason for the formulation. */
  public String formulationReason() {
    return facts.formulationReason();
  }

  /**
   * Returns the number of additions, multiplications and divisions of one evaluation of the
   * derivative.
   */
  public int operations() {
    return facts.operations();
  }

  /** Returns a description of the code, with the number of operations of each part. */
  public String code() {
    return facts.code();
  }

  /** Returns the parts that the scene does not need. */
  public List<Omission> leftOut() {
    return facts.leftOut();
  }

  /**
   * Returns the parts computed from data in addition to the code; empty for a data-driven model.
   */
  public List<Omission> fromData() {
    return facts.fromData();
  }

  /** Returns the model's name in its file. */
  public String modelName() {
    return facts.modelName();
  }
}
