package org.mechservice.solver.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.MomentumBalance;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.simulation.equations.RunEvents;

/** Collects the notes of a run from its model, its rows, its events and its method. */
final class RunNoteCollector {
  private static final Note NOT_READ_YET = new Note(MessageCode.EVENT_OCCURRED, 0, false, "");

  private final ExplicitModel model;
  private final RowWriter rows;
  private final RunEvents events;
  private final Integrator integrator;
  private final Optional<MomentumBalance> momentum;
  private final Set<MessageCode> silenced;

  /** Notes of the model in the checkpoint of a resumed run. */
  private final List<Note> notedBefore = new ArrayList<>();

  RunNoteCollector(
      ExplicitModel model,
      RowWriter rows,
      RunEvents events,
      Integrator integrator,
      Optional<MomentumBalance> momentum,
      Set<MessageCode> silenced) {
    this.silenced = silenced;
    this.momentum = momentum;
    this.model = model;
    this.rows = rows;
    this.events = events;
    this.integrator = integrator;
  }

  /** Returns all notes so far but silenced warnings. */
  List<Note> all() {
    List<Note> notes = ofModel();
    notes.addAll(rows.notes());
    notes.addAll(events.notes());
    notes.addAll(MethodNotes.of(integrator));
    momentum.ifPresent(balance -> notes.add(balance.note()));
    notes.removeIf(note -> silenced.contains(note.code()));
    return notes;
  }

  Optional<Note> firstWarning() {
    return all().stream().filter(Note::warning).findFirst();
  }

  /** Returns the model's notes; the model of a resumed run repeats those of its start. */
  private List<Note> ofModel() {
    List<Note> notes = new ArrayList<>(notedBefore);
    if (model instanceof RunNotes noted) {
      noted.notes().stream().filter(note -> !notedBefore.contains(note)).forEach(notes::add);
    }
    return notes;
  }

  /** Saves or restores the model's notes. */
  void transfer(SavedState state) {
    List<Note> noted = ofModel();
    int count = state.integer(noted.size());
    for (int i = 0; i < count; i++) {
      Note note = i < noted.size() ? noted.get(i) : NOT_READ_YET;
      MessageCode code = MessageCode.of(state.text(note.code().code()));
      double time = state.number(note.time());
      boolean warning = state.flag(note.warning());
      Note carried = new Note(code, time, warning, state.text(note.text()));
      if (state.restoring()) {
        notedBefore.add(carried);
      }
    }
  }
}
