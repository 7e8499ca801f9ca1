// The server behind a page. The token comes behind the number sign of the address that opened the page, is kept for
// this tab alone, and travels in a header that no other site can set.

const KEY = "mechservice-token";

export function takeToken() {
  const found = /^#token=([\w-]+)$/.exec(location.hash);
  if (found) {
    sessionStorage.setItem(KEY, found[1]);
    history.replaceState(null, "", "#/");
  }
}

const headers = () => ({ Authorization: `Bearer ${sessionStorage.getItem(KEY) || ""}` });

export function address(path, parameters) {
  return `/api/${path}?${new URLSearchParams(parameters)}`;
}

async function checked(response) {
  if (response.ok) return response;
  let text = `S-035 the server answered with ${response.status}`;
  try {
    text = (await response.json()).error || text;
  } catch { /* no JSON: the status says what there is to say */ }
  const failure = new Error(text);
  failure.status = response.status;
  throw failure;
}

export async function get(path, parameters = {}) {
  return (await checked(await fetch(address(path, parameters), { headers: headers() }))).json();
}

export async function post(path, body) {
  const response = await fetch(`/api/${path}`, {
    method: "POST", headers: { ...headers(), "Content-Type": "application/json" }, body: JSON.stringify(body) });
  return (await checked(response)).json();
}

/**
 * Hears server-sent events until it is closed; connects again when the connection is lost.
 *
 * handlers: an event's name and what to do with its data; opened, lost(error): optional.
 */
export function stream(path, parameters, handlers) {
  const abort = new AbortController();
  listen();
  return { close: () => abort.abort() };

  async function listen() {
    for (let pause = 500; !abort.signal.aborted; pause = Math.min(5000, pause * 2)) {
      try {
        const response = await checked(
          await fetch(address(path, parameters), { headers: headers(), signal: abort.signal }));
        handlers.opened?.();
        pause = 500;
        await read(response.body.pipeThrough(new TextDecoderStream()).getReader());
        handlers.lost?.(new Error("the connection has ended"));
      } catch (error) {
        if (abort.signal.aborted) return;
        handlers.lost?.(error);
        if (error.status === 401) return;
      }
      await new Promise(resolve => setTimeout(resolve, pause));
    }
  }

  async function read(reader) {
    let text = "";
    for (;;) {
      const { value, done } = await reader.read();
      if (done) return;
      text += value;
      for (let end = text.indexOf("\n\n"); end >= 0; end = text.indexOf("\n\n")) {
        deliver(text.slice(0, end));
        text = text.slice(end + 2);
      }
    }
  }

  function deliver(message) {
    const name = /^event: (.*)$/m.exec(message);
    const data = /^data: (.*)$/m.exec(message);
    if (name && data && handlers[name[1]]) handlers[name[1]](JSON.parse(data[1]));
  }
}
