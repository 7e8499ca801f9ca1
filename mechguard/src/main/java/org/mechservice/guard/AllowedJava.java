package org.mechservice.guard;

import java.util.Arrays;
import java.util.Collections;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

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

  /** Members of allowed classes that start threads, or query the machine or its user. */
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

  /** Classes whose objects may be passed on, although few or none of their members may be used. */
  private static final Set<String> OPAQUE =
      Set.of("java/lang/Class", "java/util/Locale", "java/util/Spliterator");

  private static final String LOOKUP = "(Ljava/lang/invoke/MethodHandles$Lookup;Ljava/lang/String;";

  /** Bootstrap methods to which the compiler links lambdas, string concatenation and records. */
  private static final Handle LAMBDA =
      bootstrap(
          "java/lang/invoke/LambdaMetafactory",
          "metafactory",
          "Ljava/lang/invoke/MethodType;Ljava/lang/invoke/MethodType;"
              + "Ljava/lang/invoke/MethodHandle;Ljava/lang/invoke/MethodType;)"
              + "Ljava/lang/invoke/CallSite;");

  private static final Handle CONCATENATION =
      bootstrap(
          "java/lang/invoke/StringConcatFactory",
          "makeConcatWithConstants",
          "Ljava/lang/invoke/MethodType;Ljava/lang/String;[Ljava/lang/Object;)"
              + "Ljava/lang/invoke/CallSite;");

  private static final Handle RECORD =
      bootstrap(
          "java/lang/runtime/ObjectMethods",
          "bootstrap",
          "Ljava/lang/invoke/TypeDescriptor;Ljava/lang/Class;Ljava/lang/String;"
              + "[Ljava/lang/invoke/MethodHandle;)Ljava/lang/Object;");

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

  private static Handle bootstrap(String owner, String name, String descriptor) {
    return new Handle(Opcodes.H_INVOKESTATIC, owner, name, LOOKUP + descriptor, false);
  }

  /** Returns whether an {@code invokedynamic} may be linked by this method. */
  static boolean isBootstrap(Handle method) {
    return method.equals(LAMBDA) || method.equals(CONCATENATION) || method.equals(RECORD);
  }

  /**
   * Returns whether a bootstrap method has the number and kinds of arguments that the compiler
   * passes: for a lambda its type, implementation and instantiated type; for a concatenation its
   * recipe and plain constants; for a record its class, the names of its components and their
   * fields.
   */
  static boolean isLinkedAsCompiled(Handle method, Object... arguments) {
    if (method.equals(LAMBDA)) {
      return arguments.length == 3
          && isMethodType(arguments[0])
          && arguments[1] instanceof Handle
          && isMethodType(arguments[2]);
    } else if (method.equals(CONCATENATION)) {
      return arguments.length > 0
          && arguments[0] instanceof String
          && Arrays.stream(arguments).allMatch(AllowedJava::isPlain);
    }
    return arguments.length > 1
        && arguments[0] instanceof Type record
        && record.getSort() == Type.OBJECT
        && arguments[1] instanceof String
        && Arrays.stream(arguments, 2, arguments.length)
            .allMatch(
                argument ->
                    argument instanceof Handle field
                        && field.getTag() == Opcodes.H_GETFIELD
                        && field.getOwner().equals(record.getInternalName()));
  }

  private static boolean isMethodType(Object argument) {
    return argument instanceof Type type && type.getSort() == Type.METHOD;
  }

  /** Returns whether a constant is a number or a text, whose loading runs no code. */
  static boolean isPlain(Object constant) {
    return constant instanceof String
        || constant instanceof Integer
        || constant instanceof Long
        || constant instanceof Float
        || constant instanceof Double;
  }
}
