package org.robonewbie.learning.policy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.robonewbie.nao.file.AtomicFile;

/** The memory of a training in a file, rewritten after each generation: what is learned, how far it is, and all its numbers. */
record TrainingState(String question, EvolutionStrategy.State state) {

    private static final int LINES = 5;

    /** Writes the file; whoever reads it gets the state before or this one, never a half. */
    void write(Path file) throws IOException {
        String text = String.join(
                "\n",
                question,
                String.valueOf(state.generation()),
                line(state.mean()),
                line(state.drift()),
                line(state.squares()));
        AtomicFile.write(file, text + "\n");
    }

    /**
     * Reads the file.
     *
     * @throws IllegalArgumentException if it belongs to another training or is damaged
     */
    static TrainingState read(Path file, String question, double... units) throws IOException {
        List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
        if (lines.isEmpty() || !lines.get(0).equals(question)) {
            throw new IllegalArgumentException(file + " belongs to another training:\n  "
                    + (lines.isEmpty() ? "(empty file)" : lines.get(0)) + "\nand not to:\n  " + question
                    + "\nGive the same options as before, or leave out --resume.");
        }
        try {
            return new TrainingState(question, state(lines, units));
        } catch (IndexOutOfBoundsException | NumberFormatException damaged) {
            throw new IllegalArgumentException(file + " is damaged. Leave out --resume.", damaged);
        }
    }

    private static EvolutionStrategy.State state(List<String> lines, double... units) {
        EvolutionStrategy.State state = new EvolutionStrategy.State(
                Integer.parseInt(lines.get(1)),
                numbers(lines.get(2)),
                units,
                numbers(lines.get(3)),
                numbers(lines.get(LINES - 1)));
        if (DoubleStream.of(state.mean().length, state.drift().length, state.squares().length)
                .anyMatch(length -> length != units.length)) {
            throw new IndexOutOfBoundsException("a line is too short");
        }
        return state;
    }

    private static String line(double... numbers) {
        return Arrays.stream(numbers).mapToObj(Double::toString).collect(Collectors.joining(" "));
    }

    private static double[] numbers(String line) {
        return Arrays.stream(line.split(" ", -1))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }
}
