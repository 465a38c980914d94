package org.robonewbie.nao.motion;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.motion.MotionLine.Frame;
import org.robonewbie.nao.motion.MotionLine.Note;
import org.robonewbie.nao.motion.MotionLine.Unreadable;
import org.robonewbie.nao.text.DecodedText;
import org.robonewbie.nao.text.UndecodableTextException;

/**
 * The contents of a motion file, including comments. Each line with a keyframe contains its duration in milliseconds
 * and 22 angles in degrees in the order of {@link org.robonewbie.nao.Joint}, separated by spaces or tabs. {@code //}
 * starts a comment, and a comment {@code // key: value} sets a property. This is the format of the original RoboNewbie
 * framework. The file of another robot than the NAO names it in a comment {@code // robot: T1}, and has an angle for each
 * joint of that robot. Immutable: each change returns a new file in which all other lines keep their exact text.
 *
 * <pre>{@code
 * MotionFile file = MotionFiles.load(Path.of("wave.txt"));
 * file.warnings().forEach(System.out::println);
 * Motion wave = file.motion();
 * }</pre>
 */
public final class MotionFile {

    private static final String BALL = "ball";
    private static final String ROBOT = "robot";
    private static final Pattern BALL_POSITION = Pattern.compile("(-?[0-9.]+) m ahead, (-?[0-9.]+) m to the left");

    private final String name;
    private final JointSpace space;
    private final DecodedText decoded;
    private final Optional<MotionProblem> decodingError;
    private final List<MotionLine> lines;

    private MotionFile(
            String name,
            JointSpace space,
            DecodedText decoded,
            Optional<MotionProblem> decodingError,
            List<MotionLine> lines) {
        this.name = name;
        this.space = space;
        this.decoded = decoded;
        this.decodingError = decodingError;
        this.lines = List.copyOf(lines);
    }

    /**
     * Parses the text of a motion file of the NAO.
     *
     * @param name the file's name, used in messages, such as {@code wave.txt}
     * @param text the contents of the file
     * @return the file; lines that cannot be parsed are kept, see {@link #errors}
     */
    public static MotionFile parse(String name, String text) {
        return parse(name, text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Decodes and parses the bytes of a motion file of the NAO.
     *
     * @param name the file's name, used in messages, such as {@code wave.txt}
     * @param bytes text in UTF-8, UTF-16 with a byte order mark, or Windows-1252
     * @return the file; bytes that cannot be decoded and lines that cannot be parsed are kept, see {@link #errors}
     */
    public static MotionFile parse(String name, byte[] bytes) {
        return parse(name, bytes, JointSpace.NAO);
    }

    /**
     * Decodes and parses the bytes of a motion file of any robot.
     *
     * @param name the file's name, used in messages, such as {@code wave.txt}
     * @param bytes text in UTF-8, UTF-16 with a byte order mark, or Windows-1252
     * @param space the joints of the robot
     * @return the file; bytes that cannot be decoded and lines that cannot be parsed are kept, see {@link #errors}
     */
    public static MotionFile parse(String name, byte[] bytes, JointSpace space) {
        try {
            DecodedText decoded = DecodedText.of(bytes);
            return new MotionFile(name, space, decoded, Optional.empty(), parseLines(decoded.content(), space));
        } catch (UndecodableTextException undecodable) {
            MotionProblem error = new MotionProblem(undecodable.line(), 1, undecodable.problem());
            String characters = new String(bytes, StandardCharsets.ISO_8859_1);
            MotionLine line = new Unreadable(characters, "", 1, error.text());
            return new MotionFile(name, space, DecodedText.EMPTY, Optional.of(error), List.of(line));
        }
    }

    private static List<MotionLine> parseLines(String content, JointSpace space) {
        List<MotionLine> lines = new ArrayList<>();
        int start = 0;
        while (start < content.length()) {
            int end = start;
            while (end < content.length() && content.charAt(end) != '\n' && content.charAt(end) != '\r') {
                end++;
            }
            int next = content.startsWith("\r\n", end) ? end + 2 : Math.min(end + 1, content.length());
            lines.add(MotionLine.parse(content.substring(start, end), content.substring(end, next), space));
            start = next;
        }
        return lines;
    }

    /**
     * Creates a file that contains a motion.
     *
     * @param motion the motion
     * @return a file with one line for each keyframe
     */
    public static MotionFile of(Motion motion) {
        List<MotionLine> lines = new ArrayList<>();
        motion.keyframes().forEach(keyframe -> lines.add(Frame.of(keyframe)));
        JointSpace space = motion.jointSpace();
        MotionFile file = new MotionFile(motion.name() + ".txt", space, DecodedText.EMPTY, Optional.empty(), lines);
        return space.equals(JointSpace.NAO) ? file : file.withProperty(ROBOT, space.robot());
    }

    /** {@return the file's name without folders, such as {@code wave.txt}} */
    public String name() {
        return name;
    }

    /**
     * Returns the motion that the file describes.
     *
     * @return the motion, named after the file without its extension
     * @throws MotionFormatException if a line cannot be parsed or there is no keyframe
     */
    public Motion motion() {
        for (MotionProblem error : errors()) {
            throw new MotionFormatException(name, error);
        }
        List<Keyframe> keyframes = keyframes();
        if (keyframes.isEmpty()) {
            throw new MotionFormatException(
                    name,
                    new MotionProblem(
                            lines.size() + 1,
                            1,
                            "no keyframe, expected at least one line with a time in milliseconds and " + space.size()
                                    + " angles"));
        }
        return new Motion(name.replaceFirst("\\.[^.]*$", ""), keyframes);
    }

    /** {@return the keyframes of all lines that can be parsed, in file order} */
    public List<Keyframe> keyframes() {
        return lines.stream()
                .filter(Frame.class::isInstance)
                .map(line -> ((Frame) line).keyframe())
                .toList();
    }

    /**
     * {@return one problem for each line that is neither a keyframe nor a comment, or a single one if the bytes cannot
     * be decoded or the motion is for another robot}
     */
    public List<MotionProblem> errors() {
        if (decodingError.isPresent()) {
            return List.of(decodingError.get());
        }
        Optional<MotionProblem> otherRobot = otherRobot();
        if (otherRobot.isPresent()) {
            return List.of(otherRobot.get());
        }
        List<MotionProblem> errors = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i) instanceof Unreadable unreadable) {
                errors.add(new MotionProblem(i + 1, unreadable.column(), unreadable.problem()));
            }
        }
        return Collections.unmodifiableList(errors);
    }

    /** Explains why this is not a motion of the robot for which it was parsed. A file that names no robot is for the NAO. */
    private Optional<MotionProblem> otherRobot() {
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i) instanceof Note note && note.property(ROBOT).isPresent()) {
                return otherRobot(i + 1, note.text(), note.property(ROBOT).get());
            }
        }
        return otherRobot(1, "", JointSpace.NAO.robot());
    }

    private Optional<MotionProblem> otherRobot(int line, String text, String found) {
        String expected = space.robot();
        if (found.equals(expected)) {
            return Optional.empty();
        }
        String what = text.isEmpty()
                ? "no line \"// robot: " + expected + "\""
                : "found \"" + found + "\", expected \"" + expected + "\"";
        return Optional.of(new MotionProblem(
                line,
                Math.max(0, text.lastIndexOf(found)) + 1,
                what + ": this motion is for the robot " + found + ", not for " + expected + ". Play it with a " + found
                        + ", or choose a motion for " + expected));
    }

    /**
     * {@return warnings about values that a robot cannot play exactly as written, such as angles beyond a joint's range
     * and durations that are not whole cycles, in file order}
     */
    public List<MotionProblem> warnings() {
        List<MotionProblem> warnings = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i) instanceof Frame frame) {
                warnings.addAll(frame.warnings(i + 1));
            }
        }
        return Collections.unmodifiableList(warnings);
    }

    /**
     * Returns a property, set by a comment {@code // key: value}.
     *
     * @param key the word before the colon
     * @return the value of the first such comment
     */
    public Optional<String> property(String key) {
        return lines.stream()
                .filter(Note.class::isInstance)
                .flatMap(line -> ((Note) line).property(key).stream())
                .findFirst();
    }

    /**
     * Returns the position at which the ball must be for the motion to kick it. A comment such as
     * {@code // ball: 0.190 m ahead, -0.055 m to the left} sets this property.
     *
     * @return the ball's position relative to the torso; empty if the file does not set one
     * @throws NumberFormatException if a distance is not a number
     */
    public Optional<Translation2d> ball() {
        Matcher position = BALL_POSITION.matcher(property(BALL).orElse(""));
        return position.find()
                ? Optional.of(
                        new Translation2d(Double.parseDouble(position.group(1)), Double.parseDouble(position.group(2))))
                : Optional.empty();
    }

    /**
     * Sets the position at which the ball must be for the motion to kick it.
     *
     * @param ball the ball's position relative to the torso
     * @return the changed file
     */
    public MotionFile withBall(Translation2d ball) {
        return withProperty(BALL, String.format(Locale.ROOT, "%.3f m ahead, %.3f m to the left", ball.x(), ball.y()));
    }

    /**
     * Sets a property, using a comment {@code // key: value}: changes the first comment with this key, or adds one at
     * the top.
     *
     * @param key the word before the colon
     * @param value the text after the colon, without line terminators
     * @return the changed file
     * @throws MotionFormatException if the bytes of the file could not be decoded
     */
    public MotionFile withProperty(String key, String value) {
        List<MotionLine> changed = new ArrayList<>(lines);
        for (int i = 0; i < changed.size(); i++) {
            if (changed.get(i) instanceof Note note && note.property(key).isPresent()) {
                changed.set(i, Note.ofProperty(key, value, note.lineEnd()));
                return with(changed);
            }
        }
        String lineEnd = lines.stream()
                .map(MotionLine::lineEnd)
                .filter(end -> !end.isEmpty())
                .findFirst()
                .orElse("\n");
        changed.add(0, Note.ofProperty(key, value, lineEnd));
        return with(changed);
    }

    /**
     * Replaces a keyframe. Unchanged numbers keep their original digits.
     *
     * @param index zero-based index of the keyframe
     * @param keyframe the new keyframe
     * @return the changed file
     * @throws IndexOutOfBoundsException if there is no such keyframe
     */
    public MotionFile withKeyframe(int index, Keyframe keyframe) {
        int next = 0;
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i) instanceof Frame frame) {
                if (next == index) {
                    List<MotionLine> changed = new ArrayList<>(lines);
                    changed.set(i, frame.with(keyframe));
                    return with(changed);
                }
                next++;
            }
        }
        throw new IndexOutOfBoundsException(
                name + " has " + next + " keyframes, so there is no keyframe " + index + ".");
    }

    /**
     * Replaces keyframes, starting with the first one, as {@link #withKeyframe} does.
     *
     * @param keyframes the new keyframes
     * @return the changed file
     * @throws IndexOutOfBoundsException if the file has fewer keyframes
     */
    public MotionFile withKeyframes(List<Keyframe> keyframes) {
        MotionFile changed = this;
        for (int i = 0; i < keyframes.size(); i++) {
            changed = changed.withKeyframe(i, keyframes.get(i));
        }
        return changed;
    }

    /** {@return the text of the file with its original line terminators, and the byte order mark if there was one} */
    public String text() {
        return (decoded.hasByteOrderMark() ? "\uFEFF" : "") + content();
    }

    private String content() {
        return lines.stream().map(line -> line.text() + line.lineEnd()).collect(Collectors.joining());
    }

    /** {@return the bytes of the file in its original encoding, or in UTF-8 if that encoding lacks one of the characters} */
    public byte[] bytes() {
        return decodingError.isPresent() ? content().getBytes(StandardCharsets.ISO_8859_1) : decoded.encode(content());
    }

    /**
     * Exchanges left and right, including in the properties {@code start} and {@code end}.
     *
     * @param newName the name of the mirrored motion, without {@code .txt}
     * @return a file with the mirrored motion
     * @throws MotionFormatException if the file cannot be parsed
     */
    public MotionFile mirrored(String newName) {
        MotionFile mirrored = of(motion().mirrored().named(newName));
        for (String key : List.of("start", "end")) {
            Optional<String> value = property(key);
            mirrored = value.isPresent() ? mirrored.withProperty(key, otherSide(value.get())) : mirrored;
        }
        return mirrored;
    }

    /** Replaces every "left" in a string with "right" or, if there is none, every "right" with "left". */
    static String otherSide(String text) {
        return text.contains("left") ? text.replace("left", "right") : text.replace("right", "left");
    }

    private MotionFile with(List<MotionLine> changed) {
        decodingError.ifPresent(error -> {
            throw new MotionFormatException(name, error);
        });
        return new MotionFile(name, space, decoded, decodingError, changed);
    }
}
