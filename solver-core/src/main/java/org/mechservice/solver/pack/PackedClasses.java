package org.mechservice.solver.pack;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/** Packs class files together, and unpacks them. */
public final class PackedClasses {
  /** Name of the entry of a JAR that holds packed classes. */
  public static final String ENTRY = "META-INF/mech.classes";

  private static final String SUFFIX = ".class";
  private static final int MAJOR_VERSION = 6;

  private PackedClasses() {}

  /**
   * Packs class files. The same classes give the same bytes.
   *
   * @param classFiles class files by path, such as {@code org/mechservice/solver/api/Model.class};
   *     not modified
   * @throws IllegalArgumentException if one of them has an attribute that running it does not need,
   *     or that is not known here
   */
  public static byte[] pack(SortedMap<String, byte[]> classFiles) {
    Bands bands = new Bands();
    List<Packing> packings = new ArrayList<>();
    Set<Constant> constants = new HashSet<>();
    bands.putSmall(BandNumbers.CLASS_COUNT, classFiles.size());
    for (byte[] classFile : classFiles.values()) {
      bands.put(BandNumbers.VERSION, classFile[MAJOR_VERSION + 1]);
      Packing packing = new Packing(classFile, bands);
      try {
        new ClassWalk(packing).walk();
      } catch (IOException e) {
        throw new IllegalStateException("bands in memory can always be written", e);
      }
      packing.collect(constants);
      packings.add(packing);
    }
    ConstantTable table = ConstantTable.of(constants);
    table.write(bands);
    packings.forEach(packing -> packing.writeReferences(table));
    return bands.deflated();
  }

  /**
   * Unpacks class files.
   *
   * @param packed what {@link #pack} returned; not modified
   * @return class files by path
   * @throws IOException if it is damaged
   */
  public static SortedMap<String, byte[]> unpack(byte[] packed) throws IOException {
    Bands bands = Bands.inflated(packed);
    int count = bands.getSmall(BandNumbers.CLASS_COUNT);
    ConstantTable table = ConstantTable.read(bands);
    SortedMap<String, byte[]> classFiles = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      int version = bands.get(BandNumbers.VERSION);
      Unpacking unpacking = new Unpacking(bands, table);
      try {
        new ClassWalk(unpacking).walk();
      } catch (IllegalArgumentException e) {
        throw new IOException("the packed classes are damaged", e);
      }
      classFiles.put(unpacking.name() + SUFFIX, unpacking.file(version));
    }
    return classFiles;
  }
}
