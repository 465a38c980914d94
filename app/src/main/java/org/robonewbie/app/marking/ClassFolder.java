package org.robonewbie.app.marking;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.robonewbie.agent.log.Spelling;
import org.robonewbie.app.program.CalledWronglyException;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.nao.file.FileNames;

/**
 * What a class has handed in: a folder for each student, or files named after student and class, such as {@code anna_Kick.java}. A
 * program belongs to the exercise whose class it has.
 */
final class ClassFolder {

    private static final String JAVA = ".java";
    private static final int DEEPEST = 12;

    private final List<Exercise> exercises;
    private final Path copies;
    private final Map<String, List<Submission>> submissions = new TreeMap<>();
    private final Map<String, String> troubles = new TreeMap<>();

    private ClassFolder(List<Exercise> exercises, Path copies) {
        this.exercises = exercises;
        this.copies = copies;
    }

    /**
     * Reads a folder.
     *
     * @param folder what was handed in
     * @param exercises the exercises that count
     * @param copies folder for files that need another name to be compiled
     * @throws CalledWronglyException if there is nothing to be graded
     */
    static ClassFolder read(Path folder, List<Exercise> exercises, Path copies) throws IOException {
        if (!Files.isDirectory(folder)) {
            throw new CalledWronglyException(
                    "There is no folder " + folder + ". It has to have one folder for each student, with .java files.");
        }
        ClassFolder all = new ClassFolder(exercises, copies);
        try (Stream<Path> entries = Files.list(folder)) {
            for (Path entry : entries.sorted().toList()) {
                all.add(entry);
            }
        }
        if (all.submissions.isEmpty()) {
            throw new CalledWronglyException(
                    "The folder " + folder + " has no programs. It has to have one folder for each"
                            + " student, such as " + folder.resolve("anna") + ", with files such as "
                            + exercises.get(0).className() + JAVA + ".");
        }
        return all;
    }

    /** All students with their programs, in the order of their names; the same exercise appears once. */
    Map<String, List<Submission>> submissions() {
        return Collections.unmodifiableMap(submissions);
    }

    /** Why there is something that cannot be graded, by student. */
    Map<String, String> troubles() {
        return Collections.unmodifiableMap(troubles);
    }

    private void add(Path entry) throws IOException {
        String name = String.valueOf(entry.getFileName());
        if (name.startsWith(".")) {
            return;
        }
        Optional<String> unreadable = FileNames.trouble(entry.toString());
        if (unreadable.isPresent()) {
            submissions.computeIfAbsent(name, any -> new ArrayList<>());
            trouble(name, unreadable.get());
            return;
        }
        if (Files.isDirectory(entry)) {
            addStudent(name, entry);
        } else if (name.endsWith(JAVA)) {
            addFlat(name, entry);
        }
    }

    private void addStudent(String student, Path folder) {
        submissions.computeIfAbsent(student, any -> new ArrayList<>());
        List<Path> programs = new ArrayList<>();
        try {
            Files.walkFileTree(folder, Set.of(), DEEPEST, new Programs(programs));
        } catch (IOException unreadable) {
            trouble(student, "The folder cannot be read: " + unreadable.getMessage());
        }
        Collections.sort(programs);
        for (Path program : programs) {
            Optional<String> unreadable = FileNames.trouble(program.toString());
            if (unreadable.isPresent()) {
                trouble(student, unreadable.get());
                continue;
            }
            String type = typeOf(String.valueOf(program.getFileName()));
            exercise(type).ifPresent(exercise -> addSubmission(new Submission(student, exercise, program, folder)));
        }
        if (submissions.getOrDefault(student, List.of()).isEmpty()) {
            trouble(student, nothingIn(programs));
        }
    }

    /** A file whose name also says whose it is; Java wants it to be named after its class alone. */
    private void addFlat(String name, Path file) throws IOException {
        String type = typeOf(name);
        Optional<Exercise> exercise = exercises.stream()
                .filter(each -> type.endsWith(each.className())
                        && type.length() > each.className().length() + 1)
                .filter(each -> "_-. "
                                .indexOf(type.charAt(
                                        type.length() - each.className().length() - 1))
                        >= 0)
                .findFirst();
        if (exercise.isEmpty()) {
            submissions.computeIfAbsent(type, any -> new ArrayList<>());
            trouble(
                    type,
                    "The file " + name + " does not say whose it is and for which exercise: anna_"
                            + exercises.get(0).className() + JAVA + " would.");
            return;
        }
        String student =
                type.substring(0, type.length() - exercise.get().className().length() - 1);
        Path folder = Files.createDirectories(copies.resolve(student));
        Path copy = folder.resolve(exercise.get().className() + JAVA);
        Files.write(copy, Files.readAllBytes(file));
        submissions.computeIfAbsent(student, any -> new ArrayList<>());
        addSubmission(new Submission(student, exercise.get(), copy, folder));
    }

    private void addSubmission(Submission submission) {
        List<Submission> own = submissions.getOrDefault(submission.student(), new ArrayList<>());
        Optional<Submission> before = own.stream()
                .filter(other -> other.exercise().equals(submission.exercise()))
                .findFirst();
        if (before.isPresent()) {
            trouble(
                    submission.student(),
                    "There are several files " + submission.exercise().className() + JAVA + "; "
                            + before.get().folder().relativize(before.get().file()) + " was graded.");
        } else {
            own.add(submission);
        }
    }

    private void trouble(String student, String sentence) {
        troubles.merge(student, sentence, (first, second) -> first + " " + second);
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

    /** Collects Java files, without hidden folders and those of builds. */
    private static final class Programs extends SimpleFileVisitor<Path> {

        private final List<Path> programs;

        Programs(List<Path> programs) {
            this.programs = programs;
        }

        @Override
        public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            String name = String.valueOf(folder.getFileName());
            boolean skipped = name.startsWith(".") || name.equals("target") || name.equals("__MACOSX");
            return skipped ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
        }

        @Override
        public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            String name = String.valueOf(file.getFileName());
            if (name.endsWith(JAVA) && !name.startsWith(".") && attributes.isRegularFile()) {
                programs.add(file);
            }
            return FileVisitResult.CONTINUE;
        }

        @Override
        public FileVisitResult visitFileFailed(Path file, IOException unreadable) {
            return FileVisitResult.CONTINUE;
        }
    }
}
