package org.robonewbie.competition.trial;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.UnixDomainSocketAddress;
import java.nio.file.Files;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.OptionalInt;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Entrant;
import org.robonewbie.competition.contest.StartPlace;
import org.robonewbie.competition.team.Start;
import org.robonewbie.programs.process.AbsentProgramException;
import org.robonewbie.programs.process.ChildProcess;
import org.robonewbie.programs.process.GuestDoor;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.SensorReadings;

/**
 * The processes of a team's program in one trial, with one process per robot. Unexpected connections are left waiting until the
 * trial ends.
 */
final class RemoteAgents implements AutoCloseable {

    private final ContestTrial trial;
    private final TrialFiles files;
    private final Limits limits;
    private final GuestDoor door;
    private final AdmissionControl admission;
    private final String team;
    private OptionalInt exitCode = OptionalInt.empty();

    /** Opens the port to which the processes connect. */
    RemoteAgents(ContestTrial trial, TrialFiles files, Limits limits, AdmissionControl admission) throws IOException {
        this.trial = trial;
        this.admission = admission;
        this.team = trial.entrants().get(0).team();
        this.files = files;
        this.limits = limits;
        this.door = openDoor();
    }

    private GuestDoor openDoor() throws IOException {
        SocketAddress address = admission
                .file(team)
                .<SocketAddress>map(UnixDomainSocketAddress::of)
                .orElse(new InetSocketAddress(InetAddress.getByAddress(new byte[] {127, 0, 0, 1}), 0));
        return GuestDoor.open(address, client -> admission.isAllowed(team, port(), client));
    }

    private int port() {
        return door.port();
    }

    private List<ChildProcess> processes() {
        return admission.processes(team);
    }

    /** Controller in another process; its response time is measured. */
    private record TimedController(Controller controller, ChildProcess process) implements Controller {

        @Override
        public void awake(SensorReadings readings) {
            respond(readings);
        }

        @Override
        public List<EffectorCommand> respond(SensorReadings readings) {
            process.passTurn();
            List<EffectorCommand> answer = controller.respond(readings);
            process.passTurn();
            return answer;
        }

        @Override
        public void close() {
            controller.close();
        }
    }

    /** Starts the program of the next robot and waits until it joins. */
    Controller next() {
        Entrant entrant = trial.entrants().get(0);
        StartPlace place = entrant.places().get(0);
        int index = processes().size();
        Start start = new Start(
                door.port(),
                entrant.team(),
                entrant.role(),
                List.of(new StartPlace(place.number() + index, place.x(), place.y(), place.degrees())));
        try {
            ChildProcess process = admission.start(start, trial.id());
            Controller controller = await(process);
            process.passTurn();
            return new TimedController(controller, process);
        } catch (IOException unstartable) {
            throw new AbsentProgramException("The program could not be started: " + unstartable, unstartable);
        }
    }

    private Controller await(ChildProcess process) {
        try {
            return door.await(() -> process.isRunning() && process.waitedSeconds() < limits.startSeconds());
        } catch (AbsentProgramException absent) {
            throw process.isRunning()
                    ? new AbsentProgramException("The program did not create a robot.", absent)
                    : absent;
        }
    }

    /** Stops all processes after one of them has failed to join or respond, appends the reason to the log, and returns the outcome. */
    Ending end(AbsentProgramException absent) throws IOException {
        Ending reason = processes().stream()
                .flatMap(process -> AdmissionControl.ending(process).stream())
                .findFirst()
                .orElse(Ending.STOPPED);
        boolean allJoined = !processes().isEmpty() && processes().stream().allMatch(ChildProcess::hasJoined);
        Ending ending = !allJoined && reason == Ending.STOPPED ? Ending.NOT_STARTED : reason;
        exitCode = reason != Ending.STOPPED
                ? OptionalInt.empty()
                : processes().stream()
                        .map(AdmissionControl::exitCode)
                        .filter(OptionalInt::isPresent)
                        .findFirst()
                        .orElse(OptionalInt.empty());
        String code = exitCode.isPresent() ? " Its exit code is " + exitCode.getAsInt() + "." : "";
        close();
        Files.writeString(
                files.logs().resolve(trial.id() + ".txt"),
                "The trial is lost: " + ending.sentence() + ". " + absent.getMessage() + code + "\n",
                StandardOpenOption.CREATE,
                StandardOpenOption.APPEND);
        return ending;
    }

    /** Returns the exit code of the first program that exited; empty before {@link #end}. */
    OptionalInt exitCode() {
        return exitCode;
    }

    @Override
    public void close() {
        processes().forEach(ChildProcess::close);
        door.close();
    }
}
