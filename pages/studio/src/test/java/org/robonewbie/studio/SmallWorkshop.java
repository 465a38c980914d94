package org.robonewbie.studio;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.programs.Remark;
import org.robonewbie.programs.completion.Proposal;
import org.robonewbie.studio.program.CompilerService;
import org.robonewbie.studio.program.RunningProgram;

/** A compiler service without a compiler: it finds no errors, and no program runs. */
record SmallWorkshop(Path folder) implements CompilerService {

    private static final String EXAMPLE = "Agent_Wave";
    private static final String PROGRAM = "public class MyAgent {\n    int degrees = 45;\n}\n";

    @Override
    public List<String> examples() {
        return List.of(EXAMPLE);
    }

    @Override
    public Optional<String> example(String name) {
        return name.equals(EXAMPLE) ? Optional.of(PROGRAM.replace("MyAgent", EXAMPLE)) : Optional.empty();
    }

    @Override
    public String newProgram(Path file, Optional<String> text) {
        return text.orElse(PROGRAM);
    }

    @Override
    public List<Remark> check(Path file, String text) {
        return List.of();
    }

    @Override
    public List<Proposal> complete(Path file, String text, int at) {
        return List.of();
    }

    @Override
    public Optional<RunningProgram> start(Path file, int port, Runnable beforeStart) {
        return Optional.empty();
    }
}
