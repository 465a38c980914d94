package org.robonewbie.web.compiling;

import java.util.Arrays;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Allowlist of the compiled classes that students' programs may use in the page. */
public final class ProgramLibrary {

    private static final String LANGUAGE =
            "Object String StringBuilder AbstractStringBuilder Math Integer Long Double Float Boolean Character Byte Short"
                    + " Number Comparable CharSequence Iterable Runnable AutoCloseable Cloneable Class System Enum Record Throwable Exception"
                    + " RuntimeException Error ArithmeticException ArrayIndexOutOfBoundsException AssertionError ClassCastException"
                    + " IllegalArgumentException IllegalStateException IndexOutOfBoundsException NegativeArraySizeException"
                    + " NullPointerException NumberFormatException StackOverflowError StringIndexOutOfBoundsException"
                    + " UnsupportedOperationException InterruptedException CloneNotSupportedException NoSuchFieldError";
    private static final String UTILITIES =
            "AbstractCollection AbstractList AbstractMap AbstractQueue AbstractSequentialList AbstractSet ArrayDeque ArrayList Arrays Collection"
                    + " Collections Comparator ConcurrentModificationException Deque HashMap HashSet Iterator LinkedHashMap LinkedHashSet"
                    + " LinkedList List ListIterator Locale Map Map$Entry NavigableMap NavigableSet NoSuchElementException Objects Optional"
                    + " OptionalDouble OptionalInt OptionalLong PrimitiveIterator$OfInt PriorityQueue Queue Random Set SortedMap SortedSet"
                    + " TreeMap TreeSet";
    private static final String STREAMS = "BaseStream Collector Collectors DoubleStream IntStream LongStream Stream";
    private static final Set<String> JAVA = Stream.of(
                    named("java.lang.", LANGUAGE),
                    named("java.util.", UTILITIES),
                    named("java.util.stream.", STREAMS),
                    named("java.util.concurrent.", "Callable"),
                    named("java.io.", "PrintStream IOException UncheckedIOException"))
            .flatMap(Set::stream)
            .collect(Collectors.toUnmodifiableSet());
    private static final String ROBONEWBIE = "org.robonewbie.";
    private static final Set<String> PACKAGES = named(
            ROBONEWBIE,
            "agent.log agent.motion agent.perception agent.walk agent.localisation nao nao.geometry nao.kinematics nao.motion"
                    + " team.skill team.tactics team.talk team.world");
    private static final Set<String> AGENT =
            named(ROBONEWBIE + "agent.", "Robot Nao Options Option Agent StartUpException Values");

    private ProgramLibrary() {}

    private static Set<String> named(String prefix, String names) {
        return Arrays.stream(names.split(" ", -1)).map(name -> prefix + name).collect(Collectors.toUnmodifiableSet());
    }

    /**
     * Returns whether programs may use a class.
     *
     * @param name binary name of the class
     * @return whether it is allowed
     */
    public static boolean has(String name) {
        int end = name.lastIndexOf('.');
        String folder = end < 0 ? "" : name.substring(0, end);
        return JAVA.contains(name)
                || AGENT.contains(name)
                || PACKAGES.contains(folder)
                || folder.equals("java.util.function");
    }

    /** {@return the names of the allowed classes of the Java class library} */
    public static Set<String> javaClasses() {
        return JAVA;
    }
}
