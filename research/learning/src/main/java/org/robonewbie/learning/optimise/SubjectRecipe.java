package org.robonewbie.learning.optimise;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.TunableNumber;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.MotionFile;

/** What a subject is made from, as texts that can be sent to another computer; a program's class has to be there already. */
final class SubjectRecipe {

    private static final String OBJECTIVE = "objective";
    private static final String NAME = "name";
    private static final String MOTION = "motion";
    private static final String AGENT = "agent";
    private static final String SCENE = "scene";
    private static final String NUMBERS = "numbers";

    private SubjectRecipe() {}

    static Map<String, String> ofEngine(Objective objective) {
        return new TreeMap<>(Map.of(OBJECTIVE, objective.label()));
    }

    static Map<String, String> ofMotion(MotionFile file, Objective objective) {
        return new TreeMap<>(Map.of(OBJECTIVE, objective.label(), NAME, file.name(), MOTION, file.text()));
    }

    static Map<String, String> ofAgent(
            String className, List<TunableNumber> numbers, AgentScene scene, Objective objective) {
        return new TreeMap<>(
                Map.of(OBJECTIVE, objective.label(), AGENT, className, SCENE, text(scene), NUMBERS, text(numbers)));
    }

    /**
     * Makes the subject again.
     *
     * @param recipe what one of the other methods has returned
     * @return the subject; candidates do there what they do here
     * @throws IllegalArgumentException if a class is missing; the message names it
     */
    static Subject subject(Map<String, String> recipe) {
        ClassLoader classes = Thread.currentThread().getContextClassLoader();
        Objective objective = Objective.named(recipe.getOrDefault(OBJECTIVE, ""), classes);
        if (recipe.containsKey(AGENT)) {
            String name = recipe.getOrDefault(AGENT, "");
            return new AgentSubject(
                    name,
                    () -> agent(name, classes),
                    objective,
                    scene(recipe.getOrDefault(SCENE, "")),
                    numbers(recipe.getOrDefault(NUMBERS, "")));
        }
        if (recipe.containsKey(MOTION)) {
            String name = recipe.getOrDefault(NAME, "");
            return new MotionSubject(name, MotionFile.parse(name, recipe.getOrDefault(MOTION, "")), objective);
        }
        return new EngineSubject(objective);
    }

    private static Agent agent(String name, ClassLoader classes) {
        try {
            return Class.forName(name, true, classes)
                    .asSubclass(Agent.class)
                    .getConstructor()
                    .newInstance();
        } catch (ReflectiveOperationException | ClassCastException wrong) {
            throw new IllegalArgumentException(
                    "The robot's class " + name + " cannot be made where the trials are carried out (" + wrong
                            + "). It has to be public, with a public constructor without parameters, in a jar that goes to"
                            + " the workers.",
                    wrong);
        }
    }

    private static String text(AgentScene scene) {
        return words(
                scene.place().x(),
                scene.place().y(),
                scene.degrees(),
                scene.ball().x(),
                scene.ball().y(),
                scene.spreadMetres(),
                scene.seconds());
    }

    private static AgentScene scene(String text) {
        double[] numbers = numbersOf(text);
        return new AgentScene(
                new Vector3(numbers[0], numbers[1], 0),
                numbers[2],
                new Vector3(numbers[3], numbers[4], 0),
                numbers[5],
                numbers[6]);
    }

    private static String text(List<TunableNumber> numbers) {
        return numbers.stream()
                .map(number -> words(number.value(), number.least(), number.most()) + " " + number.name())
                .collect(Collectors.joining("\n"));
    }

    private static List<TunableNumber> numbers(String text) {
        return text.lines()
                .map(line -> {
                    String[] words = line.split(" ", 4);
                    double value = Double.parseDouble(words[0]);
                    return new TunableNumber(
                            words[3], value, Double.parseDouble(words[1]), Double.parseDouble(words[2]), value);
                })
                .toList();
    }

    private static String words(double... numbers) {
        return Arrays.stream(numbers).mapToObj(Double::toString).collect(Collectors.joining(" "));
    }

    private static double[] numbersOf(String words) {
        return Arrays.stream(words.split(" ")).mapToDouble(Double::parseDouble).toArray();
    }
}
