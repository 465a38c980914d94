package org.robonewbie.programs.hint;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Candidates for the correction of misspelt names: the framework's most frequently used classes and their members.
 *
 * @param types full names by simple name
 * @param constants constants of all enumerations
 * @param methods public methods by simple class name, sorted, excluding the methods of {@code Object}
 */
public record FrameworkNames(
        Map<String, String> types, Collection<String> constants, Map<String, ? extends Collection<String>> methods) {

    private static final String PACKAGE = "org.robonewbie.";

    /** Full names of the classes that students' programs use most often. */
    public static final List<String> TYPES = List.of(
                    "agent.Agent",
                    "agent.Nao",
                    "agent.Options",
                    "agent.Robot",
                    "agent.localisation.Odometry",
                    "agent.localisation.SelfLocalisation",
                    "agent.log.Logger",
                    "agent.motion.LookAround",
                    "agent.motion.Motions",
                    "agent.perception.BodyPosition",
                    "agent.perception.CameraTransformation",
                    "agent.perception.FieldItem",
                    "agent.perception.HeardMessage",
                    "agent.perception.LineItem",
                    "agent.perception.LocalFieldView",
                    "agent.perception.PlayerItem",
                    "agent.walk.Walk",
                    "agent.walk.WalkParameter",
                    "agent.walk.WalkStyle",
                    "agent.walk.WalkVelocity",
                    "nao.BodyPart",
                    "nao.Joint",
                    "nao.Landmark",
                    "nao.PlayMode",
                    "nao.SoccerField",
                    "nao.TeamSide",
                    "nao.Vector3",
                    "nao.geometry.Pose2d",
                    "nao.motion.Interpolation",
                    "nao.motion.Keyframe",
                    "nao.motion.KeyframeInterval",
                    "nao.motion.Motion",
                    "nao.motion.Posture")
            .stream()
            .map(PACKAGE::concat)
            .toList();

    /** The packages of {@link #TYPES}, and the Java packages that students' programs use most often. */
    public static final List<String> PACKAGES = Stream.concat(
                    TYPES.stream().map(name -> name.substring(0, name.lastIndexOf('.'))),
                    Stream.of(
                            "java.io",
                            "java.lang",
                            "java.math",
                            "java.nio.file",
                            "java.text",
                            "java.time",
                            "java.util",
                            "java.util.concurrent",
                            "java.util.function",
                            "java.util.regex",
                            "java.util.stream"))
            .distinct()
            .toList();

    /** Methods that every object has; never proposed. */
    private static final List<String> INHERITED = List.of("equals", "hashCode", "toString");

    /**
     * Returns whether a public method is a candidate.
     *
     * @param name its name
     * @param declaredBy full name of the class that declares it
     * @return whether it is declared in a class other than {@code Object}
     */
    public static boolean isMeant(String name, String declaredBy) {
        return !declaredBy.equals("java.lang.Object") && !INHERITED.contains(name);
    }

    /** Returns the import line for a class; empty if the class is unknown. */
    Optional<String> importOf(String type) {
        return Optional.ofNullable(types.get(type)).map(name -> "import " + name + ";");
    }

    /** Returns the methods of a class, or the methods of all classes if the class is unknown. */
    List<String> methodsOf(Optional<String> type) {
        return methods.entrySet().stream()
                .filter(each -> type.map(each.getKey()::equals).orElse(true))
                .flatMap(each -> each.getValue().stream())
                .toList();
    }
}
