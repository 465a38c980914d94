package org.robonewbie.web.compiling;

import java.util.Collection;
import java.util.stream.Stream;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.teavm.extension.spi.resources.ResourcesPolicy;

/** Names the resources that go into the compiled program: the motions, and the German words of the judge. */
public final class ShippedFiles implements ResourcesPolicy {

    /** Creates the policy; TeaVM finds it by its name. */
    public ShippedFiles() {}

    @Override
    public String[] supplyResources(Collection<? extends String> classes) {
        Stream<String> motions = new ShippedMotions().names().stream().map(name -> name + ".txt");
        return Stream.concat(
                        Stream.concat(Stream.of("index"), motions).map(file -> "motions/" + file),
                        ProgramsCall.WITHOUT_PROGRAMS ? Stream.of() : wordsOfTheJudge())
                .toArray(String[]::new);
    }

    private static Stream<String> wordsOfTheJudge() {
        return Stream.of("hints-de.txt", "findings-de.txt").map(file -> "org/robonewbie/exercises/" + file);
    }
}
