//! A reader: a browser's tab, and what a person does in it.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use headless_chrome::browser::tab::ModifierKey;
use headless_chrome::browser::tab::point::Point;
use headless_chrome::protocol::cdp::Emulation::SetDeviceMetricsOverride;
use headless_chrome::protocol::cdp::Input::{
    DispatchMouseEvent, DispatchMouseEventTypeOption, MouseButton,
};
use headless_chrome::protocol::cdp::Page::CaptureScreenshotFormatOption;
use headless_chrome::protocol::cdp::types::Event;
use headless_chrome::{Browser, LaunchOptions, Tab};

pub(crate) struct Reader {
    tab: Arc<Tab>,
    errors: Arc<Mutex<Vec<String>>>,
    _browser: Browser,
}

/// The edition's folder.
pub(crate) fn edition() -> PathBuf {
    let folder = std::env::var_os("ONIONSKIN_EDITION");
    folder
        .expect("ONIONSKIN_EDITION names an edition's folder")
        .into()
}

impl Reader {
    pub(crate) fn new() -> Self {
        let options = LaunchOptions::default_builder()
            .sandbox(false)
            .window_size(Some((1200, 1000)))
            .build()
            .unwrap();
        let browser = Browser::new(options).unwrap();
        let tab = browser.new_tab().unwrap();
        let errors = Arc::new(Mutex::new(Vec::new()));
        let heard = Arc::clone(&errors);
        tab.enable_log().unwrap();
        tab.enable_runtime().unwrap();
        tab.add_event_listener(Arc::new(move |event: &Event| {
            let mut errors = heard.lock().unwrap();
            match event {
                Event::RuntimeExceptionThrown(it) => {
                    let details = &it.params.exception_details;
                    let thrown = details.exception.as_ref();
                    let thrown = thrown.and_then(|it| it.description.clone());
                    errors.push(thrown.unwrap_or_else(|| details.text.clone()));
                }
                Event::LogEntryAdded(it) => errors.push(it.params.entry.text.clone()),
                _ => {}
            }
        }))
        .unwrap();
        Self {
            tab,
            errors,
            _browser: browser,
        }
    }

    pub(crate) fn open(&self, page: &Path) {
        self.resize(1200, 1000);
        let page = page.canonicalize().unwrap();
        self.tab
            .navigate_to(&format!("file://{}", page.display()))
            .unwrap();
        self.tab.wait_until_navigated().unwrap();
    }

    /// Errors in the console since the last call.
    pub(crate) fn errors(&self) -> Vec<String> {
        std::mem::take(&mut self.errors.lock().unwrap())
    }

    /// The text that a script gives, or a promise of one.
    pub(crate) fn ask(&self, script: &str) -> String {
        let answer = self
            .tab
            .evaluate(script, true)
            .unwrap_or_else(|error| panic!("{error}: {script}"));
        match answer.value {
            Some(serde_json::Value::String(text)) => text,
            other => panic!("{script} gives {other:?}"),
        }
    }

    pub(crate) fn press(&self, keys: &[&str]) {
        for key in keys {
            self.tab.press_key(key).unwrap();
        }
    }

    pub(crate) fn press_with_shift(&self, key: &str) {
        self.tab
            .press_key_with_modifiers(key, Some(&[ModifierKey::Shift]))
            .unwrap();
    }

    pub(crate) fn resize(&self, width: u32, height: u32) {
        self.tab
            .call_method(SetDeviceMetricsOverride {
                width,
                height,
                device_scale_factor: 1.0,
                mobile: false,
                scale: None,
                screen_width: None,
                screen_height: None,
                position_x: None,
                position_y: None,
                dont_set_visible_size: None,
                screen_orientation: None,
                viewport: None,
                display_feature: None,
                device_posture: None,
            })
            .unwrap();
    }

    /// Drags one element, given by a script, to as far across as another is, and by `more` further.
    pub(crate) fn drag(&self, from: &str, to: &str, more: f64) {
        self.ask(&format!("{from}.scrollIntoView({{ block: 'center' }}); ''"));
        let middle = |of: &str| {
            let place = self.ask(&format!("(() => {{ const box = {of}.querySelector('rect').getBoundingClientRect(); return `${{box.x + box.width / 2}} ${{box.y + box.height / 2}}`; }})()"));
            let (x, y) = place.split_once(' ').unwrap();
            Point {
                x: x.parse().unwrap(),
                y: y.parse().unwrap(),
            }
        };
        let (begin, end) = (middle(from), middle(to));
        let mouse = |kind, x: f64, buttons| {
            self.tab
                .call_method(DispatchMouseEvent {
                    Type: kind,
                    x,
                    y: begin.y,
                    button: Some(MouseButton::Left),
                    buttons: Some(buttons),
                    click_count: Some(1),
                    modifiers: None,
                    timestamp: None,
                    force: None,
                    tangential_pressure: None,
                    tilt_x: None,
                    tilt_y: None,
                    twist: None,
                    delta_x: None,
                    delta_y: None,
                    pointer_Type: None,
                })
                .unwrap();
        };
        let target = end.x + more;
        mouse(DispatchMouseEventTypeOption::MousePressed, begin.x, 1);
        for step in 1..=10 {
            let x = begin.x + (target - begin.x) * f64::from(step) / 10.0;
            mouse(DispatchMouseEventTypeOption::MouseMoved, x, 1);
        }
        mouse(DispatchMouseEventTypeOption::MouseReleased, target, 0);
    }

    /// A PNG of what is in the window.
    pub(crate) fn picture(&self) -> Vec<u8> {
        let format = CaptureScreenshotFormatOption::Png;
        self.tab
            .capture_screenshot(format, None, None, true)
            .unwrap()
    }
}
