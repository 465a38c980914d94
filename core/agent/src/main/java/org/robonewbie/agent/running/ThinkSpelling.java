package org.robonewbie.agent.running;

import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robonewbie.nao.text.Spelling;

/** Detects a missing {@code think()}: a misspelt method compiles, but is never called. */
public final class ThinkSpelling {

    private static final String THINK = "think";
    private static final List<String> STEPS = List.of("sense()", THINK + "()", "act()");

    private ThinkSpelling() {}

    /**
     * Checks whether a program overrides a step of the cycle.
     *
     * @param program its class
     * @param framework the framework class that it extends
     * @param name displayed name of the class
     * @return what is wrong, as a sentence; empty if the class overrides a step of the cycle
     */
    public static Optional<String> problemIn(Class<?> program, Class<?> framework, String name) {
        List<String> methods = new ArrayList<>();
        for (Class<?> type = program; type != null && type != framework; type = type.getSuperclass()) {
            Arrays.stream(type.getDeclaredMethods())
                    .filter(method -> !method.isSynthetic())
                    .map(ThinkSpelling::heading)
                    .forEach(methods::add);
        }
        return problemAmong(methods, name);
    }

    /**
     * Checks whether a step of the cycle is among the methods of a program.
     *
     * @param methods signatures of the methods of its class and all superclasses below the framework, such as
     *     {@code thnik()} or {@code think(double)}
     * @param name displayed name of the class
     * @return what is wrong, as a sentence; empty if the class overrides a step of the cycle
     */
    public static Optional<String> problemAmong(Collection<String> methods, String name) {
        if (methods.stream().anyMatch(STEPS::contains)) {
            return Optional.empty();
        }
        Map<String, String> byName = new LinkedHashMap<>();
        methods.forEach(method -> byName.putIfAbsent(method.substring(0, method.indexOf('(')), method));
        byName.remove("main");
        String meant = Optional.ofNullable(byName.get(THINK))
                .map(method -> method + " is never called, since think() has no parameters: remove them.")
                .or(() ->
                        Spelling.nearest(THINK, byName.keySet()).map(near -> "did you mean " + byName.get(near) + "?"))
                .orElse("the robot does nothing. Put its behaviour in: protected void think() { ... }");
        return Optional.of(name + " has no think(); " + meant);
    }

    private static String heading(Method method) {
        return method.getName()
                + Arrays.stream(method.getParameterTypes())
                        .map(Class::getSimpleName)
                        .collect(Collectors.joining(", ", "(", ")"));
    }
}
