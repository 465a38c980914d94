package org.robonewbie.learning.series;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.text.ConfusableCharacter;
import org.robonewbie.nao.text.Spelling;

/**
 * Which experiment is run how often and with which parameters: all combinations of the values in order, repeated as often as
 * needed.
 *
 * @param experiment full name of a class that implements {@link Experiment}
 * @param trials the number of trials
 * @param seed chooses the seeds of all trials
 * @param values for each parameter that is a number the values to be tried, in the order of the file
 * @param texts for each parameter that is a text the texts to be tried, in the order of the file
 */
public record ExperimentPlan(
        String experiment,
        int trials,
        long seed,
        LinkedHashMap<String, List<Double>> values,
        LinkedHashMap<String, List<String>> texts) {

    private static final Pattern TEXT = Pattern.compile("\\s*\"([^\"]*)\"\\s*(,|$)");

    /** What stands before a comment; {@code #} is none within quotation marks. */
    private static final Pattern CONTENT = Pattern.compile("^(?:[^\"#]|\"[^\"]*(?:\"|$))*+");

    /** Names in a plan that are no parameters of the experiment. */
    private static final List<String> OWN = List.of("experiment", "trials", "seed");

    private static final int MAX_TRIALS = 100_000_000;

    /**
     * Reads a plan: a text file with lines {@code name=value}; {@code experiment}, {@code trials} and {@code seed} are known,
     * each other name is a parameter with values between commas, numbers or texts in quotation marks. What follows {@code #} outside
     * of these is a comment.
     *
     * @param file the file
     * @return the plan
     * @throws IOException if it cannot be read
     * @throws IllegalArgumentException if it cannot be understood; the message names the line
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
                throw new IllegalArgumentException(place + "In \"" + line + "\" " + character + ".");
            });
            if (!given.add(name)) {
                throw new IllegalArgumentException(
                        place + "\"" + name + "\" is given for the second time. All values of a"
                                + " parameter belong into one line, with commas between them.");
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
                        place + "\"" + line + "\" is not understood."
                                + (OWN.contains(name) ? "" : Spelling.question(name, OWN))
                                + " Write name=number, or name=number,number,… or name=\"text\" for a parameter.",
                        wrong);
            }
        }
        if (experiment.isEmpty() || trials < 1 || trials > MAX_TRIALS) {
            throw new IllegalArgumentException(
                    file + ": a plan needs a line experiment=NAME.OF.A.CLASS and trials from 1 to " + MAX_TRIALS
                            + "; it has \"" + experiment + "\" and " + trials + ".");
        }
        return new ExperimentPlan(experiment, trials, seed, values, texts);
    }

    private static String withoutComment(String line) {
        return CONTENT.matcher(line)
                .results()
                .map(MatchResult::group)
                .findFirst()
                .orElse("");
    }

    private static List<Double> numbers(String text) {
        List<Double> numbers = new ArrayList<>();
        for (String part : text.split(",", -1)) {
            numbers.add(Double.valueOf(part.trim()));
        }
        return List.copyOf(numbers);
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
     * Refuses parameters that the experiment does not have.
     *
     * @param known the names of those that it has
     * @throws IllegalArgumentException if the plan gives another one; the message names the nearest that there is
     */
    public void refuseOthersThan(List<String> known) {
        List<String> given = new ArrayList<>(values.keySet());
        given.addAll(texts.keySet());
        for (String name : given) {
            if (!known.contains(name)) {
                List<String> possible = new ArrayList<>(known);
                possible.addAll(OWN);
                throw new IllegalArgumentException(
                        "The plan gives a parameter \"" + name + "\", which " + experiment + " does not have."
                                + Spelling.question(name, possible) + " It has: " + String.join(", ", known) + ".");
            }
        }
    }

    /** {@return all trials in order; the seed of a trial depends on the plan's seed and the trial's number only} */
    public List<PlannedTrial> all() {
        SplittableRandom seeds = new SplittableRandom(seed);
        List<PlannedTrial> all = new ArrayList<>(trials);
        for (int i = 0; i < trials; i++) {
            long own = seeds.nextLong() >>> 1;
            LinkedHashMap<String, Double> numbers = new LinkedHashMap<>();
            LinkedHashMap<String, String> words = new LinkedHashMap<>();
            choose(texts, choose(values, i, numbers), words);
            all.add(new PlannedTrial(i, own, numbers, words));
        }
        return all;
    }

    /** Takes one choice of each parameter, and returns what is left of the number of the combination. */
    private static <T> int choose(Map<String, List<T>> parameters, int number, Map<String, T> chosen) {
        int rest = number;
        for (Map.Entry<String, List<T>> parameter : parameters.entrySet()) {
            List<T> choices = parameter.getValue();
            chosen.put(parameter.getKey(), choices.get(rest % choices.size()));
            rest /= choices.size();
        }
        return rest;
    }
}
