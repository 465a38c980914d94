package org.robonewbie.studio;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;

/** What a studio shows, if that changes: the free pitch, or the trial of an exercise. Who observes it sees what is shown. */
public final class ShownSimulation implements SimulationControl {

    private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();
    private volatile SimulationControl shown;

    /**
     * Shows a simulation.
     *
     * @param first what is shown at the beginning
     */
    public ShownSimulation(SimulationControl first) {
        this.shown = first;
    }

    /**
     * Shows another simulation. The one before goes on unseen.
     *
     * @param other what is shown from now on
     */
    public synchronized void show(SimulationControl other) {
        if (other == shown) {
            return;
        }
        observers.forEach(shown::removeObserver);
        shown = other;
        observers.forEach(other::addObserver);
    }

    @Override
    public SoccerField field() {
        return shown.field();
    }

    @Override
    public boolean hasClock() {
        return shown.hasClock();
    }

    @Override
    public void pause() {
        shown.pause();
    }

    @Override
    public void resume() {
        shown.resume();
    }

    @Override
    public void step(int cycles) {
        shown.step(cycles);
    }

    @Override
    public void setSpeed(double factor) {
        shown.setSpeed(factor);
    }

    @Override
    public void reset() {
        shown.reset();
    }

    @Override
    public void placeBall(Vector3 position, Vector3 velocity) {
        shown.placeBall(position, velocity);
    }

    @Override
    public void placeRobot(TeamSide side, int number, Vector3 position, double headingDegrees) {
        shown.placeRobot(side, number, position, headingDegrees);
    }

    @Override
    public void pushRobot(TeamSide side, int number, Vector3 newtons) {
        shown.pushRobot(side, number, newtons);
    }

    @Override
    public void kickOff(TeamSide side) {
        shown.kickOff(side);
    }

    @Override
    public void dropBall() {
        shown.dropBall();
    }

    @Override
    public void setPlayMode(PlayMode playMode) {
        shown.setPlayMode(playMode);
    }

    @Override
    public void restore(WorldSnapshot before, WorldSnapshot moment) {
        shown.restore(before, moment);
    }

    @Override
    public Optional<AgentLink> connect() {
        return shown.connect();
    }

    @Override
    public synchronized void addObserver(SimulationObserver observer) {
        observers.add(observer);
        shown.addObserver(observer);
    }

    @Override
    public synchronized void removeObserver(SimulationObserver observer) {
        observers.remove(observer);
        shown.removeObserver(observer);
    }
}
