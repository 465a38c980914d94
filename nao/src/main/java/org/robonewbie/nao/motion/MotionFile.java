package org.robonewbie.nao.motion;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
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
 * MotionFile file = MotionFile.load(Path.of("wave.txt"));
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
     * Loads a file.
     *
     * @param path the file
     * @return its content; lines that cannot be understood are kept, see {@link #errors}
     * @throws IOException if the file cannot be read
     */
    public static MotionFile load(Path path) throws IOException {
        return of(String.valueOf(path.getFileName()), Files.readAllBytes(path));
    }

    /**
     * Reads a file from a stream, such as one in the class path.
     *
     * @param name the file's name for messages, such as {@code wave.txt}
     * @param stream its bytes; not closed
     * @return its content; lines that cannot be understood are kept, see {@link #errors}
     * @throws IOException if the stream cannot be read
     */
    public static MotionFile read(String name, InputStream stream) throws IOException {
        return of(name, stream.readAllBytes());
    }

    /**
     * Understands the text of a file.
     *
     * @param name the file's name for messages, such as {@code wave.txt}
     * @param text its lines
     * @return its content; lines that cannot be understood are kept, see {@link #errors}
     */
    public static MotionFile parse(String name, String text) {
        return of(name, text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Makes a new file.
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

    private static MotionFile of(String name, byte[] bytes) {
        MotionText text = MotionText.of(bytes);
        return new MotionFile(name, text, text.parse());
    }

    /**
     * Tells the file's name.
     *
     * @return the name without folders, such as {@code wave.txt}
     */
    public String name() {
        return name;
    }

    /**
     * Gives the motion that the file describes.
     *
     * @return the motion, named as the file without its ending
     * @throws MotionFormatException if a line cannot be understood or there is no keyframe at all
     */
    public Motion motion() {
        for (MotionFinding error : errors()) {
            throw new MotionFormatException(name, error);
        }
        List<Keyframe> keyframes = keyframes();
        if (keyframes.isEmpty()) {
            throw new MotionFormatException(
                    name,
                    new MotionFinding(
                            lines.size() + 1,
                            1,
                            "no keyframe, expected at least one line with a time in milliseconds and 22 angles"));
        }
        return new Motion(name.replaceFirst("\\.[^.]*$", ""), keyframes);
    }

    /**
     * Lists the keyframes of all lines that can be understood.
     *
     * @return the keyframes in their order
     */
    public List<Keyframe> keyframes() {
        return lines.stream()
                .filter(Frame.class::isInstance)
                .map(line -> ((Frame) line).keyframe())
                .toList();
    }

    /**
     * Lists what cannot be understood.
     *
     * @return one finding for each line that is neither keyframe nor comment
     */
    public List<MotionFinding> errors() {
        List<MotionFinding> errors = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i) instanceof Unreadable unreadable) {
                errors.add(new MotionFinding(i + 1, unreadable.column(), unreadable.problem()));
            }
        }
        return Collections.unmodifiableList(errors);
    }

    /**
     * Lists what a robot cannot do quite as it is written: angles beyond a joint's range and odd times.
     *
     * @return the findings in the order of the file
     */
    public List<MotionFinding> warnings() {
        List<MotionFinding> warnings = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i) instanceof Frame frame) {
                warnings.addAll(MotionWarnings.of(i + 1, frame));
            }
        }
        return Collections.unmodifiableList(warnings);
    }

    /**
     * Looks up a fact that a comment {@code // key: value} states.
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
     * States a fact in a comment {@code // key: value}: changes the first comment with this key, or puts a new one on top.
     *
     * @param key the word before the colon
     * @param value the text after it, on one line
     * @return the changed file
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

    /**
     * Changes a keyframe; numbers that stay the same keep their digits.
     *
     * @param index which keyframe, from 0
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
     * Puts a keyframe in.
     *
     * @param index which keyframe it becomes, from 0; the number of keyframes puts it at the end
     * @param keyframe the new keyframe
     * @return the changed file
     * @throws IndexOutOfBoundsException if the index is too large or negative
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
     * Takes a keyframe out; comments stay.
     *
     * @param index which keyframe, from 0
     * @return the changed file
     * @throws IndexOutOfBoundsException if there is no such keyframe
     */
    public MotionFile withoutKeyframe(int index) {
        List<MotionLine> changed = new ArrayList<>(lines);
        changed.remove(lineOfKeyframe(index));
        return with(changed);
    }

    /**
     * Gives the text of the file.
     *
     * @return all lines with their ends as they were loaded, also a byte order mark if there was one
     */
    public String text() {
        StringBuilder all = new StringBuilder(text.byteOrderMark());
        lines.forEach(line -> all.append(line.text()).append(line.lineEnd()));
        return all.toString();
    }

    /**
     * Saves the file; nobody ever sees it half written.
     *
     * @param path where to
     * @throws IOException if the file cannot be written
     */
    public void save(Path path) throws IOException {
        Path target = path.toAbsolutePath();
        Path temporary = target.resolveSibling(target.getFileName() + "." + UUID.randomUUID() + ".tmp");
        try {
            Files.write(temporary, text.encode(text()));
            Files.move(temporary, target, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
        } finally {
            Files.deleteIfExists(temporary);
        }
    }

    private MotionFile with(List<MotionLine> changed) {
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
