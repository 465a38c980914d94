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
 * The processes of a team's program in one trial, one for each of its robots. Whoever comes through their door when no robot is
 * expected waits there until the trial is over.
 */
final class RemoteAgents implements AutoCloseable {

    private final ContestTrial trial;
    private final TrialFiles files;
    private final Limits limits;
    private final GuestDoor door;
    private final AdmissionControl doorkeeper;
    private final String team;
    private OptionalInt exitCode = OptionalInt.empty();

    /** Opens the door; nobody is there yet. */
    RemoteAgents(ContestTrial trial, TrialFiles files, Limits limits, AdmissionControl doorkeeper) throws IOException {
        this.trial = trial;
        this.doorkeeper = doorkeeper;
        this.team = trial.entrants().get(0).team();
        this.files = files;
        this.limits = limits;
        this.door = openDoor();
    }

    private GuestDoor openDoor() throws IOException {
        SocketAddress address = doorkeeper
                .file(team)
                .<SocketAddress>map(UnixDomainSocketAddress::of)
                .orElse(new InetSocketAddress(InetAddress.getByAddress(new byte[] {127, 0, 0, 1}), 0));
        return GuestDoor.open(address, guest -> doorkeeper.isWelcome(team, port(), guest));
    }

    private int port() {
        return door.port();
    }

    private List<ChildProcess> processes() {
        return doorkeeper.processes(team);
    }

    /** A program that moves a robot, and whose turns are timed. */
    private record Guest(Controller controller, ChildProcess process) implements Controller {

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

    /** Starts the program for the next robot, and waits until it comes. */
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
            ChildProcess process = doorkeeper.start(start, trial.id());
            Controller controller = await(process);
            process.passTurn();
            return new Guest(controller, process);
        } catch (IOException unstartable) {
            throw new AbsentProgramException("The program cannot be started: " + unstartable, unstartable);
        }
    }

    private Controller await(ChildProcess process) {
        try {
            return door.await(() -> process.isRunning() && process.waitedSeconds() < limits.startSeconds());
        } catch (AbsentProgramException absent) {
            throw process.isRunning() ? new AbsentProgramException("The program asked for no robot.", absent) : absent;
        }
    }

    /** Sends the rest away when one is absent, tells in the log what was noticed, and returns why it is so. */
    Ending end(AbsentProgramException absent) throws IOException {
        Ending reason = processes().stream()
                .flatMap(process -> AdmissionControl.ending(process).stream())
                .findFirst()
                .orElse(Ending.STOPPED);
        boolean came = !processes().isEmpty() && processes().stream().allMatch(ChildProcess::hasJoined);
        Ending ending = !came && reason == Ending.STOPPED ? Ending.NOT_STARTED : reason;
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

    /** The exit code of the first program that has ended; empty before {@link #end}. */
    OptionalInt exitCode() {
        return exitCode;
    }

    @Override
    public void close() {
        processes().forEach(ChildProcess::close);
        door.close();
    }
}
