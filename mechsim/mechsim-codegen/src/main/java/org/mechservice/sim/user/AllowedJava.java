package org.mechservice.sim.user;

import java.util.Collections;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Opcodes;

/**
 * The allow-list of Java classes and members for user classes: numbers, texts and collections.
 * Anything not listed is refused, so additions in later Java versions are refused too.
 */
final class AllowedJava {
  private static final Set<String> CLASSES = new TreeSet<>();

  static {
    add(
        "java/lang/",
        "Object Math StrictMath Number Double Float Long Integer Short Byte Boolean Character"
            + " String StringBuilder CharSequence Comparable Iterable Enum Record Cloneable"
            + " AutoCloseable Void Override FunctionalInterface SafeVarargs Deprecated"
            + " SuppressWarnings MatchException Throwable Exception RuntimeException Error"
            + " ArithmeticException ArrayIndexOutOfBoundsException ArrayStoreException"
            + " AssertionError ClassCastException IllegalArgumentException IllegalStateException"
            + " IndexOutOfBoundsException NegativeArraySizeException NullPointerException"
            + " NumberFormatException UnsupportedOperationException CloneNotSupportedException"
            + " StringIndexOutOfBoundsException IncompatibleClassChangeError NoSuchFieldError");
    add(
        "java/util/",
        "Collection List ArrayList LinkedList Map HashMap LinkedHashMap TreeMap Map$Entry"
            + " AbstractMap$SimpleEntry AbstractMap$SimpleImmutableEntry SortedMap NavigableMap"
            + " Set HashSet LinkedHashSet TreeSet SortedSet NavigableSet Queue Deque ArrayDeque"
            + " PriorityQueue Iterator ListIterator PrimitiveIterator PrimitiveIterator$OfDouble"
            + " PrimitiveIterator$OfInt Collections Arrays Objects Optional OptionalDouble"
            + " OptionalInt OptionalLong Comparator BitSet EnumMap EnumSet Random"
            + " SplittableRandom StringJoiner AbstractList AbstractMap AbstractSet"
            + " NoSuchElementException ConcurrentModificationException");
    add(
        "java/util/function/",
        "BiConsumer BiFunction BinaryOperator BiPredicate BooleanSupplier Consumer"
            + " DoubleBinaryOperator DoubleConsumer DoubleFunction DoublePredicate DoubleSupplier"
            + " DoubleToIntFunction DoubleToLongFunction DoubleUnaryOperator Function"
            + " IntBinaryOperator IntConsumer IntFunction IntPredicate IntSupplier"
            + " IntToDoubleFunction IntToLongFunction IntUnaryOperator LongFunction"
            + " LongToDoubleFunction LongUnaryOperator ObjDoubleConsumer ObjIntConsumer Predicate"
            + " Supplier ToDoubleBiFunction ToDoubleFunction ToIntFunction ToLongFunction"
            + " UnaryOperator");
    add("java/util/stream/", "Stream DoubleStream IntStream LongStream Collectors Collector");
  }

  /** Single members of classes that are not allowed as such. */
  private static final Set<String> MEMBERS =
      Set.of(
          "java/lang/System.arraycopy",
          "java/lang/Class.desiredAssertionStatus",
          "java/lang/Class.getSimpleName");

  /** Members of allowed classes that start threads, or ask the machine or its user. */
  private static final Set<String> FORBIDDEN =
      Set.of(
          "java/util/stream/Stream.parallel",
          "java/util/stream/DoubleStream.parallel",
          "java/util/stream/IntStream.parallel",
          "java/util/stream/LongStream.parallel",
          "java/util/Collection.parallelStream",
          "java/util/Arrays.parallelSort",
          "java/util/Arrays.parallelPrefix",
          "java/util/Arrays.parallelSetAll",
          "java/lang/Object.wait",
          "java/lang/Object.notify",
          "java/lang/Object.notifyAll",
          "java/lang/Object.finalize",
          "java/lang/Integer.getInteger",
          "java/lang/Long.getLong",
          "java/lang/Boolean.getBoolean",
          "java/lang/Throwable.printStackTrace");

  /** Classes whose objects may be handed on, although few or none of their members may be used. */
  private static final Set<String> OPAQUE =
      Set.of("java/lang/Class", "java/util/Locale", "java/util/Spliterator");

  /** What the compiler links lambdas, string concatenation and records to. */
  private static final Set<String> BOOTSTRAPS =
      Set.of(
          "java/lang/invoke/LambdaMetafactory.metafactory",
          "java/lang/invoke/StringConcatFactory.makeConcatWithConstants",
          "java/lang/runtime/ObjectMethods.bootstrap");

  private AllowedJava() {}

  private static void add(String packageName, String simpleNames) {
    Stream.of(simpleNames.split(" ", -1)).map(packageName::concat).forEach(CLASSES::add);
  }

  /**
   * Returns the members that are refused although their class is allowed, as {@code owner.name}.
   */
  static Set<String> forbiddenMembers() {
    return FORBIDDEN;
  }

  /** Returns the internal names of the classes that are allowed. */
  static Set<String> classes() {
    return Collections.unmodifiableSet(CLASSES);
  }

  static boolean isClass(String internalName) {
    return CLASSES.contains(internalName);
  }

  /** Returns whether a member of a class of Java may be used. */
  static boolean isMember(String owner, String name) {
    String member = owner + "." + name;
    boolean inherited = FORBIDDEN.stream().anyMatch(other -> other.endsWith("." + name));
    return MEMBERS.contains(member)
        || (CLASSES.contains(owner) && !FORBIDDEN.contains(member) && !inherited);
  }

  /** Returns whether an object of a class may occur among the arguments or as result of a call. */
  static boolean isHandedOn(String internalName) {
    return CLASSES.contains(internalName) || OPAQUE.contains(internalName);
  }

  /** Returns whether an {@code invokedynamic} may be linked by this method. */
  static boolean isBootstrap(Handle method) {
    return method.getTag() == Opcodes.H_INVOKESTATIC
        && BOOTSTRAPS.contains(method.getOwner() + "." + method.getName());
  }
}
