package org.robonewbie.exercises.marking;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.nao.file.PathEncoding;
import org.robonewbie.nao.file.SubmittedFolder;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.programs.CalledWronglyException;

/**
 * The submissions of all students in a course: a folder for each student, files named after the student and the Java
 * class, such as {@code anna_Kick.java}, files sent by students who use the web edition, and text files with the links
 * that they send. The name of the Java class determines the exercise.
 */
final class ClassFolder {

    private static final String JAVA = ".java";

    private final List<Exercise> exercises;
    private final Path copies;
    private final ReceivedWork received = new ReceivedWork();
    private final Map<String, List<Submission>> submissions = new TreeMap<>();
    private final Map<String, String> troubles = new TreeMap<>();

    private ClassFolder(List<Exercise> exercises, Path copies) {
        this.exercises = exercises;
        this.copies = copies;
    }

    /**
     * Reads submissions.
     *
     * @param sources folders with the submissions of a class, and single submissions
     * @param exercises the exercises to grade
     * @param copies folder for copies of the accepted files; the copies are graded
     * @param results folder for the results; ignored if it is inside a source
     * @throws CalledWronglyException if there is nothing to grade
     */
    static ClassFolder read(List<Path> sources, List<Exercise> exercises, Path copies, Path results)
            throws IOException {
        ClassFolder all = new ClassFolder(exercises, copies);
        for (Path source : sources) {
            if (Files.isDirectory(source)) {
                all.addAll(source, results.toAbsolutePath().normalize());
            } else if (Files.exists(source)) {
                if (!all.add(source)) {
                    all.note(String.valueOf(source.getFileName()), "It contains no submission.");
                }
            } else {
                throw new CalledWronglyException("There is no file or folder " + source
                        + ". Choose a folder that contains a folder for each student, with .java files.");
            }
        }
        all.addReceived();
        if (all.submissions.isEmpty() && all.troubles.isEmpty()) {
            throw new CalledWronglyException("The folder " + sources.get(0)
                    + " contains no programs. It must contain a folder for each student, such as "
                    + sources.get(0).resolve("anna") + ", with files such as "
                    + exercises.get(0).fileName() + ", or the files that students have sent.");
        }
        return all;
    }

    private void addAll(Path folder, Path results) throws IOException {
        try (Stream<Path> entries = Files.list(folder)) {
            for (Path entry : entries.sorted().toList()) {
                if (!entry.toAbsolutePath().normalize().equals(results)) {
                    add(entry);
                }
            }
        }
    }

    /** Returns the programs of all students, sorted by name, with at most one program for each exercise. */
    Map<String, List<Submission>> submissions() {
        return Collections.unmodifiableMap(submissions);
    }

    /** Returns the reasons why submissions cannot be graded, by student, or by file for files that could not be read. */
    Map<String, String> troubles() {
        return Collections.unmodifiableMap(troubles);
    }

    /** Adds a folder or file; returns whether it contains a submission or a problem to report. */
    private boolean add(Path entry) throws IOException {
        String name = String.valueOf(entry.getFileName());
        if (name.startsWith(".")) {
            return false;
        }
        Optional<String> unreadable = PathEncoding.problem(entry.toString());
        if (unreadable.isPresent()) {
            trouble(name, unreadable.get());
        } else if (name.endsWith(JAVA) && !Files.isDirectory(entry)) {
            addFlat(name, entry);
        } else if (Files.isDirectory(entry) || Files.isSymbolicLink(entry)) {
            addStudent(name, entry);
        } else {
            return HandInFile.read(entry, received);
        }
        return true;
    }

    private void addStudent(String student, Path folder) throws IOException {
        Path copy = copies.resolve(student);
        try {
            new SubmittedFolder(folder, ClassFolder::isLeftOut).copyTo(copy);
        } catch (UnreadableFileException refused) {
            trouble(student, String.valueOf(refused.getMessage()));
            return;
        }
        addPrograms(student, copy);
    }

    private void addReceived() throws IOException {
        Set<String> taken = submissions.keySet().stream()
                .map(student -> student.toLowerCase(Locale.ROOT))
                .collect(Collectors.toSet());
        for (HandIn work : received.accepted()) {
            String student = work.student();
            Optional<String> unreadable = PathEncoding.problem(student);
            if (unreadable.isPresent()) {
                trouble(student, unreadable.get());
            } else if (taken.contains(student.toLowerCase(Locale.ROOT))) {
                trouble(student, "There is another submission with this name; the one that was sent was not graded.");
            } else {
                unpack(work, copies.resolve(student));
                addPrograms(student, copies.resolve(student));
            }
        }
        received.students().forEach(student -> submissions.computeIfAbsent(student, any -> new ArrayList<>()));
        received.troubles().forEach(this::note);
    }

    /** Writes the files of a submission. {@link HandIn} has already validated their names. */
    private static void unpack(HandIn work, Path folder) throws IOException {
        for (Map.Entry<String, String> file : work.files().entrySet()) {
            Path copy = folder.resolve(file.getKey());
            Files.createDirectories(Objects.requireNonNull(copy.getParent()));
            Files.writeString(copy, file.getValue());
        }
    }

    private void addPrograms(String student, Path copy) throws IOException {
        List<Path> programs = new SubmittedFolder(copy, place -> false)
                .files().stream().filter(ClassFolder::isProgram).toList();
        for (Path program : programs) {
            Optional<String> unreadable = PathEncoding.problem(program.toString());
            if (unreadable.isPresent()) {
                trouble(student, unreadable.get());
                continue;
            }
            String type = typeOf(String.valueOf(program.getFileName()));
            exercise(type).ifPresent(exercise -> addSubmission(new Submission(student, exercise, program, copy)));
        }
        if (submissions.getOrDefault(student, List.of()).isEmpty()) {
            trouble(student, nothingIn(programs));
        }
    }

    /** Returns whether a folder is hidden or contains build output. */
    private static boolean isLeftOut(Path folder) {
        String name = String.valueOf(folder.getFileName());
        return name.startsWith(".") || name.equals("target") || name.equals("__MACOSX");
    }

    private static boolean isProgram(Path file) {
        String name = String.valueOf(file.getFileName());
        return name.endsWith(JAVA) && !name.startsWith(".");
    }

    /** Adds a file such as {@code anna_Kick.java}. The copy is named after the class, as required by Java. */
    private void addFlat(String name, Path file) throws IOException {
        String type = typeOf(name);
        Optional<Exercise> exercise = exercises.stream()
                .filter(each -> type.matches("(?s).+[-_. ]" + each.className()))
                .findFirst();
        if (exercise.isEmpty()) {
            note(
                    type,
                    "The file name " + name
                            + " must contain the student's name and the exercise. Rename the file, for example"
                            + " to anna_"
                            + exercises.get(0).fileName() + ".");
            return;
        }
        String student =
                type.substring(0, type.length() - exercise.get().className().length() - 1);
        try {
            Path admitted = new SubmittedFolder(file, place -> false).files().get(0);
            Path folder = Files.createDirectories(copies.resolve(student));
            Path copy = folder.resolve(exercise.get().fileName());
            Files.copy(admitted, copy, StandardCopyOption.REPLACE_EXISTING);
            addSubmission(new Submission(student, exercise.get(), copy, folder));
        } catch (UnreadableFileException refused) {
            trouble(student, String.valueOf(refused.getMessage()));
        }
    }

    private void addSubmission(Submission submission) {
        List<Submission> own = submissions.computeIfAbsent(submission.student(), any -> new ArrayList<>());
        Optional<Submission> before = own.stream()
                .filter(other -> other.exercise().equals(submission.exercise()))
                .findFirst();
        if (before.isPresent()) {
            trouble(
                    submission.student(),
                    "There are several files named " + submission.exercise().fileName() + "; "
                            + before.get().folder().relativize(before.get().file()) + " was graded.");
        } else {
            own.add(submission);
        }
    }

    private void trouble(String student, String sentence) {
        submissions.computeIfAbsent(student, any -> new ArrayList<>());
        note(student, sentence);
    }

    /** Records why a student's submission, or a file, cannot be graded. */
    private void note(String name, String sentence) {
        troubles.merge(name, sentence, (first, second) -> first + " " + second);
    }

    private String nothingIn(List<Path> programs) {
        List<String> names = exercises.stream().map(Exercise::className).toList();
        String found =
                programs.isEmpty() ? "There is no .java file." : "No file is named after the class of an exercise.";
        return found
                + programs.stream()
                        .map(program -> typeOf(String.valueOf(program.getFileName())))
                        .flatMap(type -> Spelling.nearest(type, names).stream()
                                .map(name -> " Is " + type + JAVA + " meant to be " + name + JAVA + "?"))
                        .findFirst()
                        .orElse("");
    }

    private Optional<Exercise> exercise(String type) {
        return exercises.stream()
                .filter(exercise -> exercise.className().equals(type))
                .findFirst();
    }

    private static String typeOf(String name) {
        return name.substring(0, name.length() - JAVA.length());
    }
}
