package org.mechservice.sim.compile;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Type;

/** The solver classes that given classes reach through the names in constant pools. */
public final class ReachableClasses {
  private static final int CLASS = 7;
  private static final int NAME_AND_TYPE = 12;
  private static final int METHOD_TYPE = 16;

  private final Function<String, byte @Nullable []> available;
  private final SortedMap<String, byte[]> reached = new TreeMap<>();
  private final Deque<byte[]> open = new ArrayDeque<>();

  private ReachableClasses(Function<String, byte @Nullable []> available) {
    this.available = available;
  }

  /**
   * Returns the class files reached, by path.
   *
   * @param roots class files to start from, by any name; not among the result
   * @param available gives the class file of a path, such as {@code
   *     org/mechservice/solver/api/Model.class}, or null for classes that are not to be reached
   */
  public static SortedMap<String, byte[]> from(
      SortedMap<String, byte[]> roots, Function<String, byte @Nullable []> available) {
    ReachableClasses reachable = new ReachableClasses(available);
    reachable.open.addAll(roots.values());
    while (!reachable.open.isEmpty()) {
      reachable.follow(reachable.open.remove());
    }
    return reachable.reached;
  }

  private void follow(byte[] classFile) {
    for (String name : namesIn(classFile)) {
      String path = name + ".class";
      if (reached.containsKey(path)) {
        continue;
      }
      byte[] named = available.apply(path);
      if (named != null) {
        reached.put(path, named);
        open.add(named);
      }
    }
  }

  /** Returns internal names of classes, and of those in the descriptors of members called. */
  public static SortedSet<String> namesIn(byte[] classFile) {
    ClassReader reader = new ClassReader(classFile);
    char[] buffer = new char[reader.getMaxStringLength()];
    SortedSet<String> names = new TreeSet<>();
    for (int item = 1; item < reader.getItemCount(); item++) {
      int at = reader.getItem(item);
      // Offset 0: the unused second half of a long or double.
      int tag = at == 0 ? 0 : reader.readByte(at - 1);
      if (tag == CLASS) {
        addElementType(Type.getObjectType(reader.readUTF8(at, buffer)), names);
      } else if (tag == NAME_AND_TYPE) {
        addDescriptor(reader.readUTF8(at + 2, buffer), names);
      } else if (tag == METHOD_TYPE) {
        addDescriptor(reader.readUTF8(at, buffer), names);
      }
    }
    return names;
  }

  private static void addDescriptor(String descriptor, SortedSet<String> names) {
    if (!descriptor.startsWith("(")) {
      addElementType(Type.getType(descriptor), names);
      return;
    }
    addElementType(Type.getReturnType(descriptor), names);
    for (Type argument : Type.getArgumentTypes(descriptor)) {
      addElementType(argument, names);
    }
  }

  private static void addElementType(Type type, SortedSet<String> names) {
    Type element = type.getSort() == Type.ARRAY ? type.getElementType() : type;
    if (element.getSort() == Type.OBJECT) {
      names.add(element.getInternalName());
    }
  }
}
