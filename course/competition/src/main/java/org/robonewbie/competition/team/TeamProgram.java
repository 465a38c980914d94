package org.robonewbie.competition.team;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Role;

/** A program that is ready to be started. */
public sealed interface TeamProgram {

    /** {@return a checksum of the program; while it stays the same, earlier results of the team are valid} */
    String fingerprint();

    /** {@return the files of the team, of which each trial gets a copy to work in} */
    Optional<Path> folder();

    /** {@return where its files are, which no other team may see} */
    List<Path> places();

    /**
     * A program in Java.
     *
     * @param classPath where its classes and files are
     * @param mainClasses the class to start for each role
     * @param folder the files of the team, of which each trial gets a copy to work in
     * @param submitted what the team handed in, from which they have been copied
     * @param together whether one process brings all players
     * @param fingerprint checksum of the program
     */
    record OfJava(
            List<Path> classPath,
            Map<Role, String> mainClasses,
            Optional<Path> folder,
            Optional<Path> submitted,
            boolean together,
            String fingerprint)
            implements TeamProgram {

        /** Makes list and map unmodifiable. */
        public OfJava {
            classPath = List.copyOf(classPath);
            mainClasses = Map.copyOf(mainClasses);
        }

        /** What its processes read. */
        List<Path> readable() {
            return Stream.concat(classPath.stream(), folder.stream())
                    .map(TeamFolder::absolute)
                    .toList();
        }

        @Override
        public List<Path> places() {
            return Stream.concat(readable().stream(), submitted.stream().map(TeamFolder::absolute))
                    .toList();
        }
    }

    /**
     * A program in any language.
     *
     * @param words program and arguments, with places such as {@code {port}} to be filled in
     * @param folder the files of the team, of which each trial gets a copy to work in
     * @param submitted the folder that the team handed in, from which they have been copied
     * @param together whether one process brings all players
     * @param fingerprint checksum of the program
     */
    record OfCommand(
            List<String> words, Optional<Path> folder, Optional<Path> submitted, boolean together, String fingerprint)
            implements TeamProgram {

        /** Makes the list unmodifiable. */
        public OfCommand {
            words = List.copyOf(words);
        }

        @Override
        public List<Path> places() {
            return Stream.of(files().stream(), folder.stream(), submitted.stream())
                    .flatMap(paths -> paths)
                    .map(TeamFolder::absolute)
                    .toList();
        }

        /** The files that its words name. */
        List<Path> files() {
            return words.stream()
                    .filter(word -> word.startsWith("/"))
                    .map(Path::of)
                    .filter(Files::exists)
                    .toList();
        }
    }

    /**
     * A program that cannot play.
     *
     * @param ending how all of its trials end
     * @param complaint what the compiler says, or which file was refused
     * @param fingerprint checksum of the program
     */
    record Broken(Ending ending, String complaint, String fingerprint) implements TeamProgram {

        @Override
        public Optional<Path> folder() {
            return Optional.empty();
        }

        @Override
        public List<Path> places() {
            return List.of();
        }
    }
}
