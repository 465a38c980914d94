package org.robonewbie.nao.motion;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.MotionLine.Frame;
import org.robonewbie.nao.motion.MotionLine.Note;
import org.robonewbie.nao.motion.MotionLine.Unreadable;

/**
 * The text of a motion, with everything that people write into it. Each line with a keyframe holds the time to get there in
 * milliseconds and 22 angles in degrees in the order of {@link org.robonewbie.nao.Joint}, separated by blanks or tabs;
 * {@code //} begins a comment. A comment {@code // key: value} keeps further facts. This is the format of the original
 * RoboNewbie framework. Unmodifiable: changes give a new file in which all other lines are kept to the letter.
 *
 * <pre>{@code
 * MotionFile file = MotionFiles.load(Path.of("wave.txt"));
 * file.warnings().forEach(System.out::println);
 * Motion wave = file.motion();
 * }</pre>
 */
public final class MotionFile {

    private final String name;
    private final MotionText text;
    private final List<MotionLine> lines;

    private MotionFile(String name, MotionText text, List<MotionLine> lines) {
        this.name = name;
        this.text = text;
        this.lines = List.copyOf(lines);
    }

    /**
     * Parses the text of a file.
     *
     * @param name the file's name for messages, such as {@code wave.txt}
     * @param text its lines
     * @return its content; lines that cannot be understood are kept, see {@link #errors}
     */
    public static MotionFile parse(String name, String text) {
        return parse(name, text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Understands the bytes of a file.
     *
     * @param name the file's name for messages, such as {@code wave.txt}
     * @param bytes text as editors save it: UTF-8, UTF-16 with a byte order mark, or Windows-1252
     * @return its content; lines that cannot be understood, and bytes that are no text, are kept, see {@link #errors}
     */
    public static MotionFile parse(String name, byte[] bytes) {
        MotionText text = MotionText.of(bytes);
        return new MotionFile(name, text, text.parse());
    }

    /**
     * Creates a new file.
     *
     * @param motion the motion that it holds
     * @return a file with one line for each keyframe
     */
    public static MotionFile of(Motion motion) {
        List<MotionLine> lines = new ArrayList<>();
        for (Keyframe keyframe : motion.keyframes()) {
            lines.add(new Frame(MotionLineFormat.format(keyframe), "\n", keyframe));
        }
        return new MotionFile(motion.name() + ".txt", MotionText.EMPTY, lines);
    }

    /** {@return the file's name without folders, such as {@code wave.txt}} */
    public String name() {
        return name;
    }

    /**
     * Returns the motion that the file describes.
     *
     * @return the motion, named like the file without its extension
     * @throws MotionFormatException if a line cannot be understood or there is no keyframe
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
                            "no keyframe, expected at least one line with a time in milliseconds and 22 angles"));
        }
        return new Motion(name.replaceFirst("\\.[^.]*$", ""), keyframes);
    }

    /** {@return the keyframes of all lines that can be understood, in their order} */
    public List<Keyframe> keyframes() {
        return lines.stream()
                .filter(Frame.class::isInstance)
                .map(line -> ((Frame) line).keyframe())
                .toList();
    }

    /** {@return the lines that cannot be understood: one problem for each line that is neither keyframe nor comment} */
    public List<MotionProblem> errors() {
        if (text.problem().isPresent()) {
            return List.of(text.problem().get());
        }
        List<MotionProblem> errors = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i) instanceof Unreadable unreadable) {
                errors.add(new MotionProblem(i + 1, unreadable.column(), unreadable.problem()));
            }
        }
        return Collections.unmodifiableList(errors);
    }

    /**
     * {@return where a robot cannot quite follow what is written, angles beyond a joint's range and odd times, in the order of
     * the file}
     */
    public List<MotionProblem> warnings() {
        List<MotionProblem> warnings = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i) instanceof Frame frame) {
                warnings.addAll(MotionWarnings.of(i + 1, frame));
            }
        }
        return Collections.unmodifiableList(warnings);
    }

    /**
     * Looks up a property, given by a comment {@code // key: value}.
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

    /** {@return where the ball must lie for the motion to kick it, from the comment {@code // ball:}} */
    public Optional<BallPlace> ball() {
        return property("ball").flatMap(BallPlace::parse);
    }

    /**
     * Sets a property in a comment {@code // key: value}: changes the first comment with this key, or adds one at the top.
     *
     * @param key the word before the colon
     * @param value the text after it, on one line
     * @return the changed file
     * @throws MotionFormatException if the bytes of the file are no text
     */
    public MotionFile withProperty(String key, String value) {
        List<MotionLine> changed = new ArrayList<>(lines);
        for (int i = 0; i < changed.size(); i++) {
            if (changed.get(i) instanceof Note note && note.property(key).isPresent()) {
                changed.set(i, Note.ofProperty(key, value, note.lineEnd()));
                return with(changed);
            }
        }
        changed.add(0, Note.ofProperty(key, value, usualLineEnd()));
        return with(changed);
    }

    /** {@return the file with a comment at the top that says what each column is, in the order of {@link Joint}} */
    public MotionFile withColumns() {
        return withProperty(
                "columns",
                Stream.concat(
                                Stream.of("milliseconds"),
                                Arrays.stream(Joint.values()).map(Joint::name))
                        .collect(Collectors.joining(", ")));
    }

    /**
     * Changes a keyframe; numbers that stay the same keep their digits.
     *
     * @param index index of the keyframe, from 0
     * @param keyframe the new keyframe
     * @return the changed file
     * @throws IndexOutOfBoundsException if there is no such keyframe
     */
    public MotionFile withKeyframe(int index, Keyframe keyframe) {
        int line = lineOfKeyframe(index);
        Frame before = (Frame) lines.get(line);
        List<MotionLine> changed = new ArrayList<>(lines);
        changed.set(line, new Frame(MotionLineFormat.replace(before, keyframe), before.lineEnd(), keyframe));
        return with(changed);
    }

    /**
     * Changes the keyframes from the first on, as {@link #withKeyframe} does.
     *
     * @param keyframes the new ones
     * @return the changed file
     * @throws IndexOutOfBoundsException if the file has fewer
     */
    public MotionFile withKeyframes(List<Keyframe> keyframes) {
        MotionFile changed = this;
        for (int i = 0; i < keyframes.size(); i++) {
            changed = changed.withKeyframe(i, keyframes.get(i));
        }
        return changed;
    }

    /**
     * Inserts a keyframe.
     *
     * @param index index that it gets, from 0; the number of keyframes appends it
     * @param keyframe the new keyframe
     * @return the changed file
     * @throws IndexOutOfBoundsException if the index is negative or too large
     */
    public MotionFile withInsertedKeyframe(int index, Keyframe keyframe) {
        List<MotionLine> changed = new ArrayList<>(lines);
        Frame inserted = new Frame(MotionLineFormat.format(keyframe), usualLineEnd(), keyframe);
        if (index < keyframes().size()) {
            changed.add(lineOfKeyframe(index), inserted);
            return with(changed);
        }
        int line = index == 0 ? changed.size() : lineOfKeyframe(index - 1) + 1;
        if (line > 0) {
            changed.set(line - 1, terminated(changed.get(line - 1)));
        }
        changed.add(line, inserted);
        return with(changed);
    }

    /**
     * Removes a keyframe; comments stay.
     *
     * @param index index of the keyframe, from 0
     * @return the changed file
     * @throws IndexOutOfBoundsException if there is no such keyframe
     */
    public MotionFile withoutKeyframe(int index) {
        List<MotionLine> changed = new ArrayList<>(lines);
        changed.remove(lineOfKeyframe(index));
        return with(changed);
    }

    /**
     * {@return the text of the file: all lines with their line ends as they were loaded, and the byte order mark if there was
     * one}
     */
    public String text() {
        return text.mark() + content();
    }

    private String content() {
        return lines.stream().map(line -> line.text() + line.lineEnd()).collect(Collectors.joining());
    }

    /** {@return the bytes of the file in the encoding in which it was loaded, or in UTF-8 if that has not all characters} */
    public byte[] bytes() {
        return text.encode(content());
    }

    /**
     * Exchanges left and right, also in the states {@code start} and {@code end}.
     *
     * @param newName the name of the mirror image, without {@code .txt}
     * @return a file with the mirrored motion
     * @throws MotionFormatException if the file cannot be understood
     */
    public MotionFile mirrored(String newName) {
        MotionFile mirrored = of(motion().mirrored().named(newName));
        for (String key : List.of("start", "end")) {
            Optional<String> value = property(key);
            mirrored = value.isPresent() ? mirrored.withProperty(key, otherSide(value.get())) : mirrored;
        }
        return mirrored;
    }

    /** Replaces each word left in a text by right, or if it has none, each right by left. */
    static String otherSide(String text) {
        return text.contains("left") ? text.replace("left", "right") : text.replace("right", "left");
    }

    /** What was not understood is not changed. */
    private MotionFile with(List<MotionLine> changed) {
        text.problem().ifPresent(problem -> {
            throw new MotionFormatException(name, problem);
        });
        return new MotionFile(name, text, changed);
    }

    private int lineOfKeyframe(int index) {
        int seen = 0;
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i) instanceof Frame) {
                if (seen == index) {
                    return i;
                }
                seen++;
            }
        }
        throw new IndexOutOfBoundsException(
                name + " has " + seen + " keyframes, so there is no keyframe " + index + ".");
    }

    private MotionLine terminated(MotionLine line) {
        if (!line.lineEnd().isEmpty()) {
            return line;
        }
        return MotionLineParser.parse(line.text(), usualLineEnd());
    }

    private String usualLineEnd() {
        return lines.stream()
                .map(MotionLine::lineEnd)
                .filter(end -> !end.isEmpty())
                .findFirst()
                .orElse("\n");
    }
}
