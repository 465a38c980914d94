package org.robonewbie.app.program;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticListener;
import javax.tools.JavaFileObject;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Nao;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.Robot;
import org.robonewbie.agent.StartPose;
import org.robonewbie.agent.localisation.GroundPose;
import org.robonewbie.agent.localisation.Odometry;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.log.Logger;
import org.robonewbie.agent.log.Spelling;
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.agent.perception.HeardMessage;
import org.robonewbie.agent.perception.LineItem;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.perception.PlayerItem;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.agent.walk.WalkParameter;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.KeyframeInterval;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * What the compiler says about a student's file, with the names of the framework that were probably meant, and the imports that are
 * missing.
 */
final class CompilerMessages implements DiagnosticListener<JavaFileObject> {

    private static final Map<String, Class<?>> TYPES = Stream.<Class<?>>of(
                    Agent.class,
                    Nao.class,
                    Robot.class,
                    Options.class,
                    StartPose.class,
                    Motions.class,
                    LookAround.class,
                    Walk.class,
                    WalkStyle.class,
                    WalkParameter.class,
                    WalkVelocity.class,
                    Logger.class,
                    LocalFieldView.class,
                    FieldItem.class,
                    PlayerItem.class,
                    LineItem.class,
                    HeardMessage.class,
                    BodyPosition.class,
                    CameraTransformation.class,
                    GroundPose.class,
                    Odometry.class,
                    SelfLocalisation.class,
                    Joint.class,
                    BodyPart.class,
                    Landmark.class,
                    PlayMode.class,
                    TeamSide.class,
                    SoccerField.class,
                    Vector3.class,
                    Keyframe.class,
                    KeyframeInterval.class,
                    Motion.class,
                    Posture.class,
                    Interpolation.class)
            .collect(Collectors.toMap(Class::getSimpleName, Function.identity()));

    private static final List<String> CONSTANTS = TYPES.values().stream()
            .filter(Class::isEnum)
            .flatMap(type -> Arrays.stream(type.getEnumConstants()))
            .map(constant -> ((Enum<?>) constant).name())
            .toList();

    /** What each object has and a student hardly means. */
    private static final Set<String> INHERITED = Set.of("equals", "hashCode", "toString");

    private static final List<String> METHODS = methods(TYPES.values().stream()).toList();

    /** Such as {@code location: class org.robonewbie.nao.motion.Posture}. */
    private static final Pattern OWNER =
            Pattern.compile("symbol: +method[^\\n]*\\R.*\\b(?:class|interface|of type) (?:\\w+\\.)*(\\w+)");

    private final List<Diagnostic<? extends JavaFileObject>> all = new ArrayList<>();
    private final Set<String> imports = new TreeSet<>();

    /** The classes of the framework that students name most. */
    static Stream<Class<?>> frameworkTypes() {
        return TYPES.values().stream();
    }

    @Override
    public void report(Diagnostic<? extends JavaFileObject> diagnostic) {
        all.add(diagnostic);
    }

    /**
     * What the compiler says about one place.
     *
     * @param mistake the compiler's own words
     * @param hint what to do; empty if nothing is to be added
     */
    record Remark(Diagnostic<? extends JavaFileObject> mistake, String hint) {}

    /** All that the compiler has said and that matters, each with what to do. */
    List<Remark> remarks() {
        return all.stream()
                .filter(each -> each.getKind() == Diagnostic.Kind.ERROR || each.getKind() == Diagnostic.Kind.WARNING)
                .map(each -> new Remark(each, hint(each)))
                .toList();
    }

    /** Prints everything in the words of the compiler, and below what to do. */
    void print(PrintStream out) {
        List<Remark> remarks = remarks();
        for (Remark each : remarks) {
            out.println(each.mistake());
            if (!each.hint().isEmpty()) {
                out.println("  " + each.hint());
            }
        }
        long errors = remarks.stream()
                .filter(each -> each.mistake().getKind() == Diagnostic.Kind.ERROR)
                .count();
        if (errors > 0) {
            out.println(errors == 1 ? "1 error" : errors + " errors");
        }
        if (!imports.isEmpty()) {
            out.println("Add at the top of the file:");
            imports.forEach(line -> out.println("  " + line));
        }
    }

    private String hint(Diagnostic<? extends JavaFileObject> mistake) {
        String name = lastName(text(mistake));
        if (isUnknown(mistake) && TYPES.containsKey(name)) {
            String line = "import " + TYPES.get(name).getName() + ";";
            imports.add(line);
            return "Add at the top of the file: " + line;
        }
        return meant(mistake)
                .map(meant -> "Did you mean " + meant + "?")
                .or(() -> offers(mistake))
                .orElseGet(() -> BeginnersHints.of(String.valueOf(mistake.getCode()), text(mistake)));
    }

    private static boolean isUnknown(Diagnostic<? extends JavaFileObject> mistake) {
        String code = String.valueOf(mistake.getCode());
        return code.contains("cant.resolve") || code.contains("enum.label");
    }

    private static Optional<String> meant(Diagnostic<? extends JavaFileObject> mistake) {
        String written = lastName(text(mistake));
        if (written.isEmpty() || !isUnknown(mistake)) {
            return Optional.empty();
        }
        boolean constant = written.equals(written.toUpperCase(Locale.ROOT));
        boolean type = Character.isUpperCase(written.charAt(0)) && !constant;
        return Spelling.nearest(
                written, constant ? CONSTANTS : type ? List.copyOf(TYPES.keySet()) : methodsWhere(mistake));
    }

    /** Of a class of the framework only its own methods can be meant. */
    private static List<String> methodsWhere(Diagnostic<? extends JavaFileObject> mistake) {
        return owner(mistake)
                .map(type -> methods(Stream.of(type)).sorted().toList())
                .orElse(METHODS);
    }

    /** What can be called where nothing similar to the written name is. */
    private static Optional<String> offers(Diagnostic<? extends JavaFileObject> mistake) {
        if (!isUnknown(mistake)) {
            return Optional.empty();
        }
        return owner(mistake)
                .map(type ->
                        type.getSimpleName() + " has the methods " + String.join(", ", methodsWhere(mistake)) + ".");
    }

    /** The class of the framework in which the compiler has looked for a method. */
    private static Optional<Class<?>> owner(Diagnostic<? extends JavaFileObject> mistake) {
        Matcher place = OWNER.matcher(mistake.getMessage(Locale.ROOT));
        return place.find() ? Optional.ofNullable(TYPES.get(place.group(1))) : Optional.empty();
    }

    private static Stream<String> methods(Stream<Class<?>> types) {
        return types.flatMap(type -> Arrays.stream(type.getMethods()))
                .filter(method -> method.getDeclaringClass() != Object.class)
                .map(Method::getName)
                .filter(name -> !INHERITED.contains(name))
                .distinct();
    }

    /** What the compiler has underlined. */
    private static String text(Diagnostic<? extends JavaFileObject> mistake) {
        JavaFileObject source = mistake.getSource();
        if (source == null || mistake.getStartPosition() == Diagnostic.NOPOS) {
            return "";
        }
        try {
            CharSequence program = source.getCharContent(true);
            return program.subSequence((int) mistake.getStartPosition(), (int) mistake.getEndPosition())
                    .toString();
        } catch (IOException unreadable) {
            return "";
        }
    }

    private static String lastName(String text) {
        String name = text.substring(text.lastIndexOf('.') + 1).strip();
        return name.matches("\\w+") ? name : "";
    }
}
