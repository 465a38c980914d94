package org.robonewbie.learning.series;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.text.ConfusableCharacter;
import org.robonewbie.nao.text.Spelling;

/**
 * Plan of a series (full factorial design): the trials cycle through all combinations of parameter values.
 *
 * @param experiment full name of a class that implements {@link Experiment}
 * @param trials the number of trials, 1 to 100 million
 * @param seed the seed from which the seeds of the trials are derived
 * @param values the values of each numeric parameter, in the order of the file
 * @param texts the values of each text parameter, in the order of the file
 */
public record ExperimentPlan(
        String experiment,
        int trials,
        long seed,
        LinkedHashMap<String, List<Double>> values,
        LinkedHashMap<String, List<String>> texts) {

    private static final Pattern TEXT = Pattern.compile("\\s*\"([^\"]*)\"\\s*(,|$)");

    /** Matches the text before a comment; {@code #} within quotation marks does not start a comment. */
    private static final Pattern CONTENT = Pattern.compile("^(?:[^\"#]|\"[^\"]*(?:\"|$))*+");

    /** Names in a plan that are not parameters of the experiment. */
    private static final List<String> RESERVED = List.of("experiment", "trials", "seed");

    private static final int MAX_TRIALS = 100_000_000;

    /**
     * Reads a plan, a text file with lines {@code name=value}. Names other than {@code experiment}, {@code trials} and {@code seed} are
     * parameters; their values are numbers or quoted strings, separated by commas. An unquoted {@code #} starts a comment.
     *
     * @param file the file
     * @return the plan
     * @throws IOException if the file cannot be read
     * @throws IllegalArgumentException if a line is invalid; the message contains the line number
     */
    public static ExperimentPlan read(Path file) throws IOException {
        String experiment = "";
        int trials = 1;
        long seed = 1;
        LinkedHashMap<String, List<Double>> values = new LinkedHashMap<>();
        LinkedHashMap<String, List<String>> texts = new LinkedHashMap<>();
        Set<String> given = new HashSet<>();
        List<String> lines = TextFile.readAndNote(file).lines();
        for (int i = 0; i < lines.size(); i++) {
            String line = withoutComment(lines.get(i)).trim();
            int equals = line.indexOf('=');
            if (line.isEmpty()) {
                continue;
            }
            String name = line.substring(0, Math.max(0, equals)).trim();
            String value = line.substring(equals + 1).trim();
            String place = file + ", line " + (i + 1) + ": ";
            ConfusableCharacter.firstIn(value.startsWith("\"") ? name : line).ifPresent(character -> {
                throw new IllegalArgumentException(place + "In \"" + line + "\", " + character + ".");
            });
            if (!given.add(name)) {
                throw new IllegalArgumentException(place + "\"" + name
                        + "\" is set twice. Write all values of a parameter on one line," + " separated by commas.");
            }
            try {
                switch (name) {
                    case "" -> throw new NumberFormatException();
                    case "experiment" -> experiment = value;
                    case "trials" -> trials = Integer.parseInt(value);
                    case "seed" -> seed = Long.parseLong(value);
                    default -> {
                        if (value.startsWith("\"")) {
                            texts.put(name, texts(value));
                        } else {
                            values.put(name, numbers(value));
                        }
                    }
                }
            } catch (NumberFormatException wrong) {
                throw new IllegalArgumentException(
                        place + "\"" + line + "\" is not a valid line."
                                + (RESERVED.contains(name) ? "" : Spelling.question(name, RESERVED))
                                + " Write name=number, or name=number,number,… or name=\"text\" for a parameter.",
                        wrong);
            }
        }
        if (experiment.isEmpty() || trials < 1 || trials > MAX_TRIALS) {
            throw new IllegalArgumentException(
                    file + ": a plan needs a line experiment=NAME.OF.A.CLASS and trials from 1 to " + MAX_TRIALS
                            + "; this one has \"" + experiment + "\" and " + trials + ".");
        }
        return new ExperimentPlan(experiment, trials, seed, values, texts);
    }

    private static String withoutComment(String line) {
        Matcher content = CONTENT.matcher(line);
        return content.find() ? content.group() : "";
    }

    private static List<Double> numbers(String text) {
        return Arrays.stream(text.split(",", -1))
                .map(part -> Double.valueOf(part.trim()))
                .toList();
    }

    private static List<String> texts(String value) {
        List<String> texts = new ArrayList<>();
        Matcher next = TEXT.matcher(value);
        int end = 0;
        while (end < value.length() && next.find(end) && next.start() == end) {
            texts.add(next.group(1));
            end = next.end();
        }
        if (end < value.length() || value.endsWith(",")) {
            throw new NumberFormatException();
        }
        return List.copyOf(texts);
    }

    /**
     * Rejects parameters that the experiment does not define.
     *
     * @param known the names of the experiment's parameters
     * @throws IllegalArgumentException if the plan contains an unknown parameter; the message suggests a similar name
     */
    public void requireKnown(List<String> known) {
        List<String> given = new ArrayList<>(values.keySet());
        given.addAll(texts.keySet());
        for (String name : given) {
            if (!known.contains(name)) {
                List<String> possible = new ArrayList<>(known);
                possible.addAll(RESERVED);
                throw new IllegalArgumentException(
                        "The plan has a parameter \"" + name + "\", which " + experiment + " does not have."
                                + Spelling.question(name, possible) + " It has: " + String.join(", ", known) + ".");
            }
        }
    }

    /**
     * {@return all trials, ordered by number; a trial's seed depends only on its number and on the seed of the plan}
     */
    public List<PlannedTrial> all() {
        SplittableRandom seeds = new SplittableRandom(seed);
        List<PlannedTrial> all = new ArrayList<>(trials);
        for (int i = 0; i < trials; i++) {
            long trialSeed = seeds.nextLong() >>> 1;
            LinkedHashMap<String, Double> numbers = new LinkedHashMap<>();
            LinkedHashMap<String, String> words = new LinkedHashMap<>();
            choose(texts, choose(values, i, numbers), words);
            all.add(new PlannedTrial(i, trialSeed, numbers, words));
        }
        return all;
    }

    /**
     * Decodes the index of a combination (mixed radix) by choosing a value for each parameter; returns the remaining
     * quotient for further parameters.
     */
    private static <T> int choose(Map<String, List<T>> parameters, int index, Map<String, T> chosen) {
        int quotient = index;
        for (Map.Entry<String, List<T>> parameter : parameters.entrySet()) {
            List<T> choices = parameter.getValue();
            chosen.put(parameter.getKey(), choices.get(quotient % choices.size()));
            quotient /= choices.size();
        }
        return quotient;
    }
}
