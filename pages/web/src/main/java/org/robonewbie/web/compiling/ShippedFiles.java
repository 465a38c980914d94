package org.robonewbie.web.compiling;

import java.util.Arrays;
import java.util.Collection;
import java.util.stream.Stream;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.FirstMinute;
import org.robonewbie.exercises.Language;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.teavm.extension.spi.resources.ResourcesPolicy;

/** TeaVM policy that adds resources to the module: the motions and the exercise texts. */
public final class ShippedFiles implements ResourcesPolicy {

    /** Creates the policy; TeaVM finds it by name. */
    public ShippedFiles() {}

    @Override
    public String[] supplyResources(Collection<? extends String> classes) {
        Stream<String> motions = new ShippedMotions().names().stream().map(name -> name + ".txt");
        Stream<String> translations = Stream.of("hints-de.txt", "findings-de.txt");
        Stream<String> exercises =
                Stream.concat(translations, Exercises.all().stream().flatMap(ShippedFiles::filesOf));
        Stream<String> levels = FirstMinute.levels().stream()
                .map(level -> level.className() + ".java.txt")
                .flatMap(file -> Stream.of("start/" + file, "start/solved/" + file));
        return Stream.concat(
                        Stream.concat(Stream.of("index"), motions).map(file -> "motions/" + file),
                        Stream.concat(exercises, levels).map(file -> "org/robonewbie/exercises/" + file))
                .toArray(String[]::new);
    }

    private static Stream<String> filesOf(Exercise exercise) {
        return Stream.concat(
                Stream.of("start/" + exercise.className() + ".java.txt"),
                Arrays.stream(Language.values()).map(language -> "worksheet/" + language.worksheet(exercise) + ".md"));
    }
}
