package org.robonewbie.pagejvm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class MachineTest {

    @Test
    void calculatesAsJavaDoes() {
        assertThat(
                        said(
                                "System.out.println((7 / 2) + \" \" + (-7 % 3) + \" \" + (7 >>> 1) + \" \" + (char) ('a' + 1) + \" \" + 1e10"
                                        + " + \" \" + (int) 3.99 + \" \" + (long) 1e18 + \" \" + (float) 0.1 + \" \" + (byte) 200 + \" \" + (5L << 40));"))
                .isEqualTo("3 -1 3 b 1.0E10 3 1000000000000000000 0.1 -56 5497558138880");
    }

    @Test
    void loopsSwitchesAndArraysWork() {
        assertThat(said("int[][] grid = new int[3][2]; grid[1][1] = 4; int sum = 0;"
                        + " for (int[] row : grid) for (int one : row) sum += one;"
                        + " String text = switch (sum) { case 4 -> \"four\"; default -> \"other\"; };"
                        + " switch (text) { case \"four\": System.out.print(1); case \"x\": System.out.print(2); break; default: }"
                        + " System.out.println(text + grid.length);"))
                .isEqualTo("12four3");
    }

    @Test
    void recordsEnumerationsAndInterfacesOfTheProgramWork() {
        assertThat(
                        said(
                                "System.out.println(new Point(1, 2) + \" \" + new Point(1, 2).equals(new Point(1, 2)) + \" \" + Mood.valueOf(\"GLAD\")"
                                        + ".ordinal() + \" \" + Mood.values().length + \" \" + Mood.GLAD.hello() + \" \" + new Circle(2).area());"))
                .isEqualTo("Point[x=1.0, y=2.0] true 1 2 glad! 4.0");
    }

    @Test
    void lambdasReachJavasLibrary() {
        assertThat(said("List<String> words = new ArrayList<>(List.of(\"pear\", \"fig\", \"apple\"));"
                        + " words.sort(Comparator.comparing(String::length));"
                        + " System.out.println(words + \" \" + words.stream().map(w -> w.charAt(0)).toList() + \" \""
                        + " + words.stream().mapToInt(String::length).sum() + \" \" + words.stream().filter(w -> w.length() > 3)"
                        + ".collect(Collectors.joining(\"+\")));"))
                .isEqualTo("[fig, pear, apple] [f, p, a] 12 pear+apple");
    }

    @Test
    void objectsOfTheProgramWorkInCollections() {
        assertThat(said("Map<Point, Integer> seen = new HashMap<>(); seen.merge(new Point(1, 1), 1, Integer::sum);"
                        + " seen.merge(new Point(1, 1), 1, Integer::sum); List<Point> points = new ArrayList<>(seen.keySet());"
                        + " points.add(new Point(0, 5)); Collections.sort(points);"
                        + " System.out.println(seen + \" \" + points.get(0).y());"))
                .isEqualTo("{Point[x=1.0, y=1.0]=2} 5.0");
    }

    @Test
    void exceptionsAreCaughtWhereTheyBelong() {
        assertThat(
                        said(
                                "try { Object o = \"x\"; Integer i = (Integer) o; } catch (ClassCastException e) { System.out.print(\"cast \"); }"
                                        + " try { int[] a = {}; a[0] = 1; } catch (RuntimeException e) { System.out.print(e.getMessage() + \" \"); }"
                                        + " finally { System.out.print(\"finally \"); }"
                                        + " try { List.of().get(0); } catch (IndexOutOfBoundsException e) { System.out.print(\"list \"); }"
                                        + " try { throw new Tired(\"so\"); } catch (IllegalStateException e) { System.out.println(e.getMessage()); }"))
                .isEqualTo("cast Index 0 out of bounds for length 0 finally list so");
    }

    @Test
    void uncaughtExceptionHasTheLine() {
        assertThatThrownBy(() -> said("int zero = 0;\nint one = 1 / zero;"))
                .isInstanceOf(ArithmeticException.class)
                .satisfies(mistake -> assertThat(mistake.getStackTrace()[0]).hasToString("Try.main(Try.java:11)"));
    }

    @Test
    void endlessLoopIsReportedWithItsLine() {
        assertThatThrownBy(() -> said("int i = 0;\nwhile (true) { i++; }"))
                .isInstanceOf(EndlessLoop.class)
                .hasMessageContaining("Try.java:11")
                .hasMessageContaining("Is there an infinite loop?");
    }

    @Test
    void endlessRecursionIsReported() {
        assertThatThrownBy(() -> said("deeper(1);"))
                .isInstanceOf(StackOverflowError.class)
                .hasMessage("Does deeper() call itself without end?");
    }

    @Test
    void classThatExtendsAnotherOfJavaIsRefused() {
        String text = "public class Try extends java.util.ArrayList<String> {}";

        assertThatThrownBy(() -> new Program(JavaSource.compile("Try", text).values()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("Try extends java.util.ArrayList, which this page does not support");
    }

    @Test
    void damagedClassFileIsRefused() {
        assertThatThrownBy(() -> ClassFileReader.read(new byte[] {1, 2, 3, 4}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("This is not a class file.");
    }

    private static String said(String code) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Machine machine =
                new Machine(program(code), new PrintStream(bytes, true, StandardCharsets.UTF_8), SpecialCalls.NONE);
        machine.begin("Try");
        while (!machine.resume()) {
            // no call waits
        }
        return bytes.toString(StandardCharsets.UTF_8).strip();
    }

    private static Program program(String code) {
        String text = """
                import java.util.*;
                import java.util.stream.*;
                public class Try {
                    record Point(double x, double y) implements Comparable<Point> {
                        public int compareTo(Point o) { return Double.compare(x, o.x); } }
                    enum Mood { SAD, GLAD { String hello() { return "glad!"; } }; String hello() { return "oh"; } }
                    interface Shape { double area(); } record Circle(double r) implements Shape { public double area() { return r * r; } }
                    static class Tired extends IllegalStateException { Tired(String s) { super(s); } }
                    static int deeper(int n) { return deeper(n + 1); }
                    public static void main(String[] args) throws Exception { %s }
                }
                """.formatted(code);
        return new Program(JavaSource.compile("Try", text).values());
    }
}
