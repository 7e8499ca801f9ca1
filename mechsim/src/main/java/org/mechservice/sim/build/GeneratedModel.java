package org.mechservice.sim.build;

import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.mechservice.sim.build.emit.CompactClass;
import org.mechservice.sim.build.emit.ModelClass;
import org.mechservice.sim.build.emit.WrittenClass;

/**
 * A model specialised to its scene: what its class computes, planned, ready to be written as Java
 * source or as a class file. Immutable.
 */
public final class GeneratedModel {
  private final WrittenClass written;
  private final Optional<CompactClass> columns;
  private final Optional<WrittenClass> values;
  private final String modelName;
  private final String formulation;
  private final String formulationReason;
  private final int operations;
  private final List<Omission> leftOut;
  private final List<Omission> fromData;

  /**
   * @param written what the class computes
   * @param columns what extends it by columns that no code is generated for
   * @param values what its events watch and assign, and its outputs
   * @param modelName the model's name in its file
   * @param formulation formulation its equations are written in
   * @param formulationReason why this formulation
   * @param operations additions, multiplications and divisions of one evaluation of the derivative
   * @param leftOut what the scene does not need
   * @param fromData what the data beside the code compute
   */
  GeneratedModel(
      WrittenClass written,
      Optional<CompactClass> columns,
      Optional<WrittenClass> values,
      String modelName,
      String formulation,
      String formulationReason,
      int operations,
      List<Omission> leftOut,
      List<Omission> fromData) {
    this.written = written;
    this.columns = columns;
    this.values = values;
    this.modelName = modelName;
    this.formulation = formulation;
    this.formulationReason = formulationReason;
    this.operations = operations;
    this.leftOut = List.copyOf(leftOut);
    this.fromData = List.copyOf(fromData);
  }

  /** Returns the fully qualified name of the class to be instantiated. */
  public String className() {
    return columns.isPresent() ? name(columns.get()) : sourceName();
  }

  /** Returns the fully qualified name of the class that has the equations. */
  public String sourceName() {
    return name(written);
  }

  private static String name(WrittenClass written) {
    return ModelClass.PACKAGE + "." + written.simpleName();
  }

  /** Returns the class that has the equations as formatted source, for people. */
  public String source() {
    return written.source();
  }

  /**
   * Returns the sources of all its classes, that of {@link #source} first: compiled together they
   * are the model.
   */
  public List<SourceFile> sources() {
    return Stream.of(Stream.of(written), columns.stream(), values.stream())
        .flatMap(part -> part)
        .map(part -> new SourceFile(name(part), part.source()))
        .toList();
  }

  /**
   * Returns the class files by binary name; that of the equations computes what {@link #source}
   * says, bit by bit.
   */
  SortedMap<String, byte[]> classFiles() {
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

  /** Returns the formulation its equations are written in. */
  public String formulation() {
    return formulation;
  }

  /** Returns why this formulation. */
  public String formulationReason() {
    return formulationReason;
  }

  /** Returns additions, multiplications and divisions of one evaluation of the derivative. */
  public int operations() {
    return operations;
  }

  /** Returns how the model computes, and how many operations each part of it takes. */
  public String code() {
    return written.code();
  }

  /** Returns what the scene does not need. */
  public List<Omission> leftOut() {
    return leftOut;
  }

  /** Returns what is computed from the data beside the code; nothing of a model that is data. */
  public List<Omission> fromData() {
    return fromData;
  }

  /** Returns the model's name in its file. */
  public String modelName() {
    return modelName;
  }
}
